#include "core/solve/auto/shrinkage_kernel.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

constexpr int kCount = 37;  // no multiple of the lanes
constexpr size_t kPadded = 48;
constexpr float kNoise = 1e-4F;

/// Each light alone in a shot, contributions independent (P = I): every matrix of the model is the identity,
/// and what the kernel should say can be written down.
ShrinkagePlan plainPlan(int lights) {
  const size_t d = size_t(3 * lights);
  ShrinkagePlan plan;
  plan.lights = plan.shots = lights;
  plan.constant = kNoise;
  plan.color.assign(d * size_t(lights), 0);
  plan.shape.assign(d, 1);
  plan.singular.assign(d, 1);
  plan.greyPower.assign(d, 1.0F / float(lights));
  std::vector<float> identity(d * d, 0);
  for (size_t m = 0; m < d; ++m) identity[m * d + m] = 1;
  plan.toModes = plan.modes = plan.fromModes = identity;
  plan.whiten = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int k = 0; k < lights; ++k)
    for (int c = 0; c < 3; ++c) plan.color[size_t((k * 3 + c) * lights + k)] = 1;
  plan.prior.scale = {0, .01F, .03F, .2F};
  plan.prior.weight = {.4F, .3F, .2F, .1F};
  return plan;
}

/// Random contributions, nearly matte, and the matte model that fits them best: their first singular vectors.
struct Scene {
  int lights;
  ShrinkagePlan plan;
  std::vector<Eigen::MatrixXd> truth, matte;  ///< lights x channels, a pixel
  std::vector<std::vector<float>> planes;
  PixelRun in;
  MatteRun fit;

  explicit Scene(int lightCount) : lights(lightCount), plan(plainPlan(lightCount)) {
    const size_t n = size_t(lights);
    planes.assign(3 * n + n + 4, std::vector<float>(kPadded, .1F));
    std::mt19937 random(static_cast<unsigned>(lights));
    std::uniform_real_distribution<double> unit(0, 1);
    for (size_t p = 0; p < kCount; ++p) {
      Eigen::MatrixXd t(lights, 3);
      Eigen::Vector3d albedo = Eigen::Vector3d::NullaryExpr([&] { return .2 + .6 * unit(random); });
      for (int i = 0; i < lights; ++i) t.row(i) = (.1 + unit(random)) * albedo.transpose();
      t += Eigen::MatrixXd::NullaryExpr(lights, 3, [&] { return .01 * (unit(random) - .5); });
      const Eigen::JacobiSVD<Eigen::MatrixXd> svd(t, Eigen::ComputeThinU | Eigen::ComputeThinV);
      Eigen::VectorXd share = svd.matrixU().col(0);
      Eigen::Vector3d rho = svd.matrixV().col(0) * svd.singularValues()[0] * share.sum();
      share /= share.sum();
      truth.push_back(t);
      matte.emplace_back(share * rho.transpose());
      for (size_t i = 0; i < n; ++i) {
        for (size_t c = 0; c < 3; ++c) planes[i * 3 + c][p] = float(t(long(i), long(c)));
        planes[3 * n + i][p] = float(share[long(i)]);
      }
      for (size_t c = 0; c < 3; ++c) planes[4 * n + c][p] = float(rho[long(c)]);
      planes[4 * n + 3][p] = .001F;
    }
    in.count = kCount;
    for (size_t i = 0; i < n; ++i) {
      for (size_t c = 0; c < 3; ++c) in.signal[i][c] = planes[i * 3 + c].data();
      fit.share[i] = planes[3 * n + i].data();
    }
    for (size_t c = 0; c < 3; ++c) fit.reflectance[c] = planes[4 * n + c].data();
    fit.variance = planes[4 * n + 3].data();
  }

  /// log evidence of scale j over that of scale 0.
  [[nodiscard]] double evidence(size_t p, size_t j) const {
    const double v = kNoise, s = double(plan.prior.scale[j]) * plan.prior.scale[j] + v;
    const double square = (truth[p] - matte[p]).squaredNorm();
    const int free = 3 * lights - (lights + 3 - 1);  // values less parameters of the matte model
    return .5 * (free * std::log(v / s) - square * (1 / s - 1 / v));
  }
};

class ShrinkageKernel : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Lights, ShrinkageKernel, testing::Values(2, 3, 4, 6));

TEST_P(ShrinkageKernel, TheEvidenceIsThatOfTheGaussianModelAtEveryLevel) {
  const Scene scene(GetParam());
  std::vector<std::vector<float>> evidence(ShrinkagePrior::kScales, std::vector<float>(kPadded));
  ShrinkageRun out;
  for (size_t j = 0; j < evidence.size(); ++j) out.logEvidence[j] = evidence[j].data();
  test::atEveryLevel([&] {
    SWAPLIGHT_KERNEL(shrinkRun)(scene.plan, scene.in, scene.fit, nullptr, nullptr, out);
    for (size_t j = 1; j < evidence.size(); ++j)
      for (size_t p = 0; p < kCount; ++p) {
        const double expected = scene.evidence(p, j);
        ASSERT_NEAR(evidence[j][p] - evidence[0][p], expected, 1e-3 * (1 + std::abs(expected)));
      }
  });
}

TEST_P(ShrinkageKernel, TheAnswerIsTheMeanOfTheScalesByTheirEvidenceAtEveryLevel) {
  const Scene scene(GetParam());
  const size_t n = size_t(scene.lights);
  std::vector<std::vector<float>> planes(3 * n + 2, std::vector<float>(kPadded));
  std::vector<float> odds(kPadded, 2);
  SolvedRun solved;
  for (size_t i = 0; i < n; ++i)
    for (size_t c = 0; c < 3; ++c) solved.contribution[i][c] = planes[i * 3 + c].data();
  solved.sigma = planes[3 * n].data();
  ShrinkageRun out;
  out.solved = &solved;
  out.notMatte = planes[3 * n + 1].data();
  test::atEveryLevel([&] {
    SWAPLIGHT_KERNEL(shrinkRun)(scene.plan, scene.in, scene.fit, odds.data(), nullptr, out);
    for (size_t p = 0; p < kCount; ++p) {
      double sum = scene.plan.prior.weight[0], pull = 0, spread = 0;
      for (size_t j = 1; j < ShrinkagePrior::kScales; ++j) {
        const double weight = 2.0 * scene.plan.prior.weight[j] * std::exp(scene.evidence(p, j));
        const double tau2 = double(scene.plan.prior.scale[j]) * scene.plan.prior.scale[j];
        sum += weight;
        pull += weight * tau2 / (tau2 + kNoise);  // how far from the matte fit to the photographs
        spread += weight * 3 * tau2 * kNoise / (tau2 + kNoise);
      }
      const Eigen::MatrixXd expected = scene.matte[p] + pull / sum * (scene.truth[p] - scene.matte[p]);
      for (size_t i = 0; i < n; ++i)
        for (size_t c = 0; c < 3; ++c)
          ASSERT_NEAR(planes[i * 3 + c][p], expected(long(i), long(c)), 2e-5) << p;
      ASSERT_NEAR(planes[3 * n + 1][p], 1 - scene.plan.prior.weight[0] / sum, 2e-3) << p;
      const double sigma = std::sqrt(.001 + spread / sum / (expected.sum() * expected.sum()));
      ASSERT_NEAR(planes[3 * n][p], sigma, 2e-3 * sigma) << p;
    }
  });
}

}  // namespace
}  // namespace swaplight
