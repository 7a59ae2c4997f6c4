#include "core/solve/highlights/highlights.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>
#include <string_view>
#include <utility>

#include "core/solve/solve_photographs.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kWidth = 480, kHeight = 288;
constexpr float kError = 0.002F;  // standard error of a channel

/// A surface of this colour under two lights that fade from left to right, and from right to left; each has a
/// round highlight of this height in its half.
struct Plate {
  SolvedSet set;
  std::vector<Image> highlights;

  Plate(const Rgb& color, float height, unsigned seed = 1, float error = kError) {
    std::mt19937 random(seed);
    std::normal_distribution<float> gauss;
    const ImageSpec spec = ImageSpec::rgb(kWidth, kHeight);
    for (int i = 0; i < 2; ++i) {
      set.capture.lights.push_back({i == 0 ? "left" : "right", Role::Other, {}});
      set.contributions.emplace_back(spec);
      highlights.emplace_back(spec);
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const float along = float(i == 0 ? kWidth - x : x) / kWidth;
          const float away = std::hypot(float(x) - (i == 0 ? 144.0F : 336.0F), float(y) - 144);
          const float peak = height * std::exp(-away * away / 60);
          for (int c = 0; c < 3; ++c) {
            highlights.back().span().at(c, x, y) = peak;
            set.contributions.back().span().at(c, x, y) =
                std::max(0.0F, color[c] * (0.1F + 0.3F * along) + peak + error * gauss(random));
          }
        }
    }
    updateBeta(set);
    set.quality = Image({kWidth, kHeight, {"residual", "sigma", "flags", "model"}, "data"}, 0);
    for (size_t p = 0; p < set.quality.pixelCount(); ++p) {
      float sum = 0;
      for (const Image& light : set.contributions)
        for (int c = 0; c < 3; ++c) sum += light.plane(c)[p] / 3;
      set.quality.plane(kSigma)[p] = sum > 0 ? error / sum : 1;
    }
    set.report.emplace();
  }

  /// Relative error (RMS) of what was found of a light.
  [[nodiscard]] double error(size_t light) const {
    double square = 0, power = 0;
    for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
      const double truth = double{highlights[light].plane(0)[p]};
      square += std::pow(double{set.highlights[light].plane(0)[p]} - truth, 2);
      power += truth * truth;
    }
    return std::sqrt(square / power);
  }
};

TEST(Highlights, OfAColouredSurfaceAreFound) {
  for (const float height : {0.3F, 1.0F}) {
    Plate plate({0.5F, 0.15F, 0.1F}, height);
    findHighlights(plate.set);
    ASSERT_EQ(plate.set.highlights.size(), 2U) << height;
    EXPECT_LT(plate.error(0), height < 1 ? 0.2 : 0.1) << height;
    EXPECT_LT(plate.error(1), height < 1 ? 0.2 : 0.1) << height;
    EXPECT_GT(plate.set.report->highlights, 0.005);
  }
}

TEST(Highlights, HaveNoHolesWhereAPixelAloneDoesNotShowThem) {
  Plate plate({0.6F, 0.25F, 0.15F}, 0.8F);
  // Noise that makes the light as colourful as the surface, and the other one as bright: no highlight by
  // itself.
  const int x = 146, y = 145;
  Image& left = plate.set.contributions[0];
  Image& right = plate.set.contributions[1];
  for (int c = 0; c < 3; ++c) right.span().at(c, x, y) = 0;
  for (int c = 0; c < 3; ++c) right.span().at(c, x, y - 1) = 0;
  findHighlights(plate.set);
  ASSERT_FALSE(plate.set.highlights.empty());
  const ImageView found = plate.set.highlights[0].view(), truth = plate.highlights[0].view();
  for (const int row : {y, y - 1}) {
    EXPECT_NEAR(found.at(0, x, row), truth.at(0, x, row), .15 * truth.at(0, x, row));
    EXPECT_LE(found.at(0, x, row), left.view().at(2, x, row)) << "no more than its darkest channel";
  }
  EXPECT_EQ(plate.set.highlights[1].view().at(0, x, y), 0) << "the other light has none there";
}

TEST(Highlights, AreNoLongerLookedForWhenTheWorkIsStopped) {
  Plate plate({0.5F, 0.15F, 0.1F}, 1);
  std::atomic<bool> stop = false;
  const Progress progress{[&](float fraction, std::string_view) { stop = fraction > 0.5F; }, &stop};
  EXPECT_THROW(findHighlights(plate.set, progress), Stopped);
}

TEST(Highlights, LieWithinTheirLightInEveryChannel) {
  Plate plate({0.5F, 0.15F, 0.1F}, 1);
  findHighlights(plate.set);
  ASSERT_EQ(plate.set.highlights.size(), 2U);
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < plate.set.beta.pixelCount(); ++p) {
        ASSERT_GE(plate.set.highlights[i].plane(c)[p], 0);
        ASSERT_LE(plate.set.highlights[i].plane(c)[p], plate.set.contributions[i].plane(c)[p]);
      }
}

TEST(Highlights, ChangeNothingElse) {
  Plate plate({0.5F, 0.15F, 0.1F}, 1);
  const Plate same({0.5F, 0.15F, 0.1F}, 1);
  findHighlights(plate.set);
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < plate.set.beta.pixelCount(); ++p)
        ASSERT_EQ(plate.set.contributions[i].plane(c)[p], same.set.contributions[i].plane(c)[p]);
}

TEST(Highlights, FollowTheirLightsWhereThoseChangePlaces) {
  Plate one({0.5F, 0.15F, 0.1F}, 1), other({0.5F, 0.15F, 0.1F}, 1);
  std::swap(other.set.contributions[0], other.set.contributions[1]);
  findHighlights(one.set);
  findHighlights(other.set);
  ASSERT_EQ(one.set.highlights.size(), 2U);
  ASSERT_EQ(other.set.highlights.size(), 2U);
  for (size_t i = 0; i < 2; ++i)
    for (size_t p = 0; p < one.set.beta.pixelCount(); ++p)
      ASSERT_EQ(one.set.highlights[i].plane(0)[p], other.set.highlights[1 - i].plane(0)[p]);
}

TEST(Highlights, NoiseIsNone) {
  for (unsigned seed = 1; seed < 6; ++seed)
    for (const float error : {0.0F, 0.002F, 0.01F, 0.05F}) {
      Plate plate({0.5F, 0.15F, 0.1F}, 0, seed, error);
      findHighlights(plate.set);
      EXPECT_TRUE(plate.set.highlights.empty()) << error;
      EXPECT_EQ(plate.set.report->message, "");
    }
}

TEST(Highlights, OfAGreySurfaceCannotBeTold) {
  Plate plate(Rgb(0.4F), 1);
  findHighlights(plate.set);
  EXPECT_TRUE(plate.set.highlights.empty());
}

TEST(Highlights, AWhiteStripeIsNone) {
  Plate plate({0.5F, 0.15F, 0.1F}, 0);
  for (Image& light : plate.set.contributions)
    for (int y = 120; y < 140; ++y)
      for (int x = 0; x < kWidth; ++x)
        light.span().at(1, x, y) = light.span().at(2, x, y) = light.span().at(0, x, y);
  findHighlights(plate.set);
  EXPECT_TRUE(plate.set.highlights.empty());
}

TEST(Highlights, OneLightOrNoneIsLeftAsItIs) {
  Plate plate({0.5F, 0.15F, 0.1F}, 1);
  plate.set.contributions.pop_back();
  plate.set.capture.lights.pop_back();
  updateBeta(plate.set);
  findHighlights(plate.set);
  EXPECT_TRUE(plate.set.highlights.empty());
  Plate dark(Rgb(0), 0, 1, 0);
  findHighlights(dark.set);
  EXPECT_TRUE(dark.set.highlights.empty());
}

TEST(Highlights, AreKeptByASolveUnlessItIsToldNotTo) {
  const Plate plate({0.5F, 0.15F, 0.1F}, 1, 1, 0);
  SyntheticSet truth(2, 0);
  truth.width = kWidth, truth.height = kHeight;
  truth.truth.clear();
  for (const Image& light : plate.set.contributions) truth.truth.push_back(light.clone());
  Capture capture = rotatedCapture(2);
  capture.noise = SensorNoise{0.001, 50000};
  const CapturePixels pixels = photograph(capture, truth);
  for (const Model model : {Model::Auto, Model::Gloss, Model::Transport, Model::Lambert}) {
    SolveOptions options;
    options.model = model;
    const auto solved = [&] {
      CapturePixels copy = withoutShots(pixels);
      for (const Image& shot : pixels.shots) copy.shots.push_back(shot.clone());
      return solvePhotographs(capture, std::move(copy), {}, options);
    };
    const SolvedSet with = solved();
    options.highlights = false;
    const SolvedSet without = solved();
    if (model == Model::Gloss) {
      EXPECT_FALSE(with.highlights.empty());
    } else if (model == Model::Lambert) {
      EXPECT_TRUE(with.highlights.empty());
    }
    EXPECT_TRUE(without.highlights.empty());
    for (size_t i = 0; i < 2; ++i)
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < with.beta.pixelCount(); ++p)
          ASSERT_EQ(with.contributions[i].plane(c)[p], without.contributions[i].plane(c)[p]);
  }
}

}  // namespace
}  // namespace swaplight
