#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/solve/estimators/gloss_fit.h"
#include "core/solve/estimators/matte_fit.h"
#include "tests/support/processor_levels.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kCount = 37;  // no multiple of the lanes
constexpr size_t kPadded = 48;

/// Matte pixels, photographed under rotated colours. One in five has a dark light, one in seven lost a value.
struct Scene {
  int lights;
  EstimatorContext context;
  std::vector<std::vector<float>> truth;   ///< shares, then reflectances
  std::vector<std::vector<float>> values;  ///< [shot * 3 + channel]
  PixelRun in;

  Scene(int lightCount, NoiseModel noise, float sigma, float gloss = 0) : lights(lightCount) {
    context.lighting = lightingFromCapture(rotatedCapture(lights));
    context.noise = noise;
    std::mt19937 random(static_cast<unsigned>(lights));
    std::uniform_real_distribution<float> unit(0, 1);
    std::normal_distribution<float> gauss;
    truth.assign(size_t(lights) + 3, std::vector<float>(kPadded, 0));
    values.assign(size_t(3 * context.lighting.shots), std::vector<float>(kPadded, 0));
    for (size_t p = 0; p < kCount; ++p) {
      float sum = 0;
      for (int i = 0; i < lights; ++i)
        sum += truth[size_t(i)][p] = p % 5 == 0 && i == int(p / 5) % lights ? 0 : .05F + unit(random);
      for (int i = 0; i < lights; ++i) truth[size_t(i)][p] /= sum;
      for (size_t c = 0; c < 3; ++c) truth[size_t(lights) + c][p] = .1F + .8F * unit(random);
      for (int k = 0; k < context.lighting.shots; ++k)
        for (int c = 0; c < 3; ++c) {
          double y = 0;
          for (int i = 0; i < lights; ++i)
            y += context.lighting.color(k, i)[c] *
                 (truth[size_t(i)][p] * truth[size_t(lights + c)][p] + (p % 3 == 0 && i == 0 ? gloss : 0));
          values[size_t(k * 3 + c)][p] = float(y) + sigma * gauss(random);
        }
      if (p % 7 == 2 && lights > 2) values[p % values.size()][p] = NAN;
    }
    in.count = kCount;
    for (int k = 0; k < context.lighting.shots; ++k)
      for (int c = 0; c < 3; ++c) in.signal[k][c] = values[size_t(k * 3 + c)].data();
  }

  /// What MatteFit says of shares, in double (the formulas of matte_fit.h).
  struct Fit {
    double rho[3] = {};
    double misfit = 0;
  };
  [[nodiscard]] Fit assess(size_t p, const std::vector<double>& u) const {
    Fit out;
    for (int c = 0; c < 3; ++c) {
      double gg = 0, gy = 0;
      eachValue(p, c, u, [&](double y, double g) { gg += g * g, gy += g * y; });
      const double guess = std::max(gy / gg, 0.0);
      double energy = 0, wgy = 0, wgg = 0;
      eachValue(p, c, u, [&](double y, double g) {
        const double s = g * guess;
        const double w = 1 / (context.noise.constant + s * (context.noise.linear + s * context.noise.square));
        energy += w * y * y, wgy += w * g * y, wgg += w * g * g;
      });
      out.rho[c] = std::max(wgy, 0.0) / wgg;
      out.misfit += energy - out.rho[c] * std::max(wgy, 0.0);
    }
    return out;
  }

 private:
  template <typename Work>
  void eachValue(size_t p, int c, const std::vector<double>& u, const Work& work) const {
    for (int k = 0; k < context.lighting.shots; ++k) {
      const double y = values[size_t(k * 3 + c)][p];
      if (std::isnan(y)) continue;
      double g = 0;
      for (int i = 0; i < lights; ++i) g += double(context.lighting.color(k, i)[c]) * u[size_t(i)];
      work(y, g);
    }
  }
};

/// Planes for a fit.
struct Answer {
  std::vector<std::vector<float>> planes;
  MatteRun run;
  explicit Answer(int lights) : planes(size_t(lights) + 6, std::vector<float>(kPadded)) {
    size_t next = 0;
    for (int i = 0; i < lights; ++i) run.share[i] = planes[next++].data();
    for (float*& plane : run.reflectance) plane = planes[next++].data();
    run.misfit = planes[next++].data();
    run.variance = planes[next++].data();
    run.shareVariance = planes[next++].data();
  }
};

class MatteKernel : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Lights, MatteKernel, testing::Values(2, 3, 4, 5, 8));

TEST_P(MatteKernel, AssessesSharesAsTheFormulasSayAtEveryLevel) {
  const Scene scene(GetParam(), {1e-5F, 1e-4F, 1e-3F}, .003F);
  const MatteFit fit(scene.context);
  Answer answer(scene.lights);
  for (int i = 0; i < scene.lights; ++i)
    std::copy_n(scene.truth[size_t(i)].data(), kPadded, answer.run.share[i]);
  test::atEveryLevel([&] {
    fit.assess(scene.in, answer.run);
    for (size_t p = 0; p < kCount; ++p) {
      std::vector<double> u;
      for (int i = 0; i < scene.lights; ++i) u.push_back(answer.run.share[i][p]);
      const Scene::Fit expected = scene.assess(p, u);
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(answer.run.reflectance[c][p], expected.rho[c], 1e-5) << p;
      ASSERT_NEAR(answer.run.misfit[p], expected.misfit, .02 + 1e-3 * expected.misfit) << p;
    }
  });
}

TEST_P(MatteKernel, FindsTheTruthOfExactPhotographsAtEveryLevel) {
  const Scene scene(GetParam(), {1e-8F, 0, 0}, 0);
  const MatteFit fit(scene.context);
  Answer answer(scene.lights);
  test::atEveryLevel([&] {
    fit.fit(scene.in, answer.run);
    for (size_t p = 0; p < kCount; ++p) {
      for (int i = 0; i < scene.lights; ++i)
        ASSERT_NEAR(answer.run.share[i][p], scene.truth[size_t(i)][p], 2e-3)
            << "pixel " << p << ", light " << i;
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(answer.run.reflectance[c][p], scene.truth[size_t(scene.lights + c)][p], 2e-3) << p;
    }
  });
}

TEST(MatteKernel, OfTwoLightsIsTheMinimumThatASearchFindsAtEveryLevel) {
  const Scene scene(2, {1e-4F, 0, 0}, .01F);
  const MatteFit fit(scene.context);
  Answer answer(2);
  test::atEveryLevel([&] {
    fit.fit(scene.in, answer.run);
    for (size_t p = 0; p < kCount; ++p) {
      double least = INFINITY;
      for (int step = 0; step <= 4000; ++step)
        least = std::min(least, scene.assess(p, {step / 4000.0, 1 - step / 4000.0}).misfit);
      EXPECT_NEAR(answer.run.misfit[p], least, .03 + .01 * least)
          << p;  // a step that gains less is not taken
    }
  });
}

TEST(MatteKernel, TheVarianceOfSharesIsTheInverseCurvatureAtEveryLevel) {
  const Scene scene(2, {1e-4F, 0, 0}, 0);
  const MatteFit fit(scene.context);
  Answer answer(2);
  test::atEveryLevel([&] {
    fit.fit(scene.in, answer.run);
    for (size_t p = 0; p < kCount; ++p) {
      const double u = answer.run.share[0][p], h = 1e-3;
      if (u < .05 || u > .95) continue;
      const auto misfit = [&](double at) { return scene.assess(p, {at, 1 - at}).misfit; };
      const double curvature = (misfit(u - h) - 2 * misfit(u) + misfit(u + h)) / (2 * h * h);
      EXPECT_NEAR(answer.run.shareVariance[p] * curvature, 1, .02) << p;
    }
  });
}

TEST(GlossKernel, ItsResidualIsWhatItsContributionsLeaveAtEveryLevel) {
  for (const int lights : {2, 3, 4, 5}) {
    const NoiseModel noise{1e-4F, 0, 0};
    const Scene scene(lights, noise, .01F, .3F);
    if (!GlossFit::fits(scene.context.lighting)) continue;
    const GlossFit fit(scene.context);
    std::vector<std::vector<float>> planes(size_t(lights) * 3 + 2, std::vector<float>(kPadded));
    SolvedRun out;
    for (int i = 0; i < lights; ++i)
      for (int c = 0; c < 3; ++c) out.contribution[i][c] = planes[size_t(i * 3 + c)].data();
    out.residual = planes[size_t(lights) * 3].data();
    out.sigma = planes[size_t(lights) * 3 + 1].data();
    const int shots = scene.context.lighting.shots;
    const float freedom = float(std::max(3 * shots - 2 * lights - 2, 1));
    test::atEveryLevel([&] {
      fit.estimate(scene.in, out);
      for (size_t p = 0; p < kCount; ++p) {
        double left = 0;
        for (int k = 0; k < shots; ++k)
          for (int c = 0; c < 3; ++c) {
            double y = scene.values[size_t(k * 3 + c)][p];
            if (std::isnan(y)) continue;
            for (int i = 0; i < lights; ++i)
              y -= double(scene.context.lighting.color(k, i)[c]) * out.contribution[i][c][p];
            left += y * y / noise.constant;
          }
        ASSERT_NEAR(out.residual[p] * out.residual[p] * freedom, left, .01 + 1e-3 * left)
            << lights << ", " << p;
        ASSERT_TRUE(std::isfinite(out.sigma[p]) && out.sigma[p] > 0) << p;
        for (int i = 0; i < lights; ++i)
          for (int c = 0; c < 3; ++c) ASSERT_GE(out.contribution[i][c][p], 0) << p;
      }
    });
  }
}

TEST(GlossKernel, FindsHighlightsOfExactPhotographsAtEveryLevel) {
  const int lights = 3;
  const Scene scene(lights, {1e-8F, 0, 0}, 0, .3F);
  const GlossFit fit(scene.context);
  std::vector<std::vector<float>> planes(size_t(lights) * 3, std::vector<float>(kPadded));
  SolvedRun out;
  for (int i = 0; i < lights; ++i)
    for (int c = 0; c < 3; ++c) out.contribution[i][c] = planes[size_t(i * 3 + c)].data();
  test::atEveryLevel([&] {
    fit.estimate(scene.in, out);
    double error = 0, power = 0;
    for (size_t p = 0; p < kCount; ++p) {
      if (p % 7 == 2) continue;  // a value is missing
      for (int i = 0; i < lights; ++i)
        for (int c = 0; c < 3; ++c) {
          const double t = scene.truth[size_t(i)][p] * scene.truth[size_t(lights + c)][p] +
                           (p % 3 == 0 && i == 0 ? .3F : 0);
          error += std::pow(out.contribution[i][c][p] - t, 2), power += t * t;
        }
    }
    EXPECT_LT(std::sqrt(error / power), .03);
  });
}

}  // namespace
}  // namespace swaplight
