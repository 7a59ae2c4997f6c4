#include "core/solve/calibration/color_evidence.h"

#include <gtest/gtest.h>

#include "core/solve/calibration/color_fit.h"
#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kLights = 3;
constexpr int kPatch = 16;  // pixels
constexpr SensorNoise kCamera{.002, 20000};

/// Patches of one albedo each, a quarter of a light's in its shadow, without any of it. `bounce`: the part by
/// which a light's contribution to a channel may be more than matte.
SyntheticSet patches(float bounce, float shadow = .25F) {
  SyntheticSet set(kLights, 0);
  set.width = 512;
  set.height = 256;
  set.truth.clear();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < kLights; ++i) set.truth.emplace_back(ImageSpec::rgb(set.width, set.height));
  for (int top = 0; top < set.height; top += kPatch)
    for (int left = 0; left < set.width; left += kPatch) {
      float albedo[3];
      for (float& a : albedo) a = .2F + .6F * unit(random);
      for (Image& t : set.truth) {
        const float least = shadow > 0 ? .1F : .3F;
        const float shading = unit(random) < shadow ? 0 : least + (.4F - least) * unit(random);
        for (int c = 0; c < 3; ++c) {
          const float value = shading * albedo[c] * (1 + bounce * unit(random));
          for (int y = top; y < top + kPatch; ++y)
            std::fill_n(t.plane(c) + size_t(y) * size_t(set.width) + size_t(left), kPatch, value);
        }
      }
    }
  return set;
}

/// The capture with every colour off by a normal factor of the standard deviation `error`.
Capture wrong(const Capture& capture, float error) {
  Capture result = capture;
  std::mt19937 random(5);
  std::normal_distribution<float> gauss;
  for (Shot& shot : result.shots)
    for (auto& color : shot.lightColors)
      for (int c = 0; c < 3; ++c) (*color)[c] *= 1 + error * gauss(random);
  return result;
}

struct Judged {
  float visible = 0, byEvidence = 0;
};

Judged judge(const Capture& said, const CapturePixels& pixels) {
  const EstimatorContext context{lightingFromCapture(said), noiseModel(kCamera, pixels, 0)};
  const ShotSignal signal(pixels, context.lighting, context.noise, {1, 1, 1});
  Judged judged;
  judged.visible = colorUncertaintyOf(fitColors(context, signal));
  judged.byEvidence = colorUncertaintyByEvidence(context, signal, judged.visible).value_or(-1);
  return judged;
}

Capture taken() {
  Capture capture = rotatedCapture(kLights);
  capture.noise = kCamera;
  return capture;
}

TEST(ColorEvidence, WrongColoursShowAsNegativeLight) {
  for (const float error : {.03F, .06F}) {
    const Judged judged = judge(wrong(taken(), error), photograph(taken(), patches(0)));
    EXPECT_GT(judged.byEvidence, .5F * error);
    EXPECT_LT(judged.byEvidence, 3 * error);
  }
}

TEST(ColorEvidence, BouncedLightIsNoErrorOfTheColours) {
  const Judged judged = judge(taken(), photograph(taken(), patches(.5F)));
  EXPECT_GT(judged.visible, 2 * judged.byEvidence) << "by the matte model's misfit they look wrong";
  EXPECT_LT(judged.byEvidence, .015F);
}

TEST(ColorEvidence, SaysNothingWhereNoLightIsBlockedAnywhere) {
  const Judged judged = judge(wrong(taken(), .03F), photograph(taken(), patches(0, 0)));
  EXPECT_EQ(judged.byEvidence, -1) << "wrong colours would not show";
}

double errorOf(Model model, const Capture& capture, const CapturePixels& pixels, const SyntheticSet& truth) {
  SolveOptions options;
  options.model = model;
  const SolvedSet set = solve(capture, pixels, options);
  double sum = 0;
  for (size_t i = 0; i < kLights; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p)
        sum += std::pow(double(set.contributions[i].plane(c)[p]) - truth.truth[i].plane(c)[p], 2);
  return std::sqrt(sum);
}

/// The capture, with the camera's noise told or not.
Capture telling(Capture capture, bool noise) {
  if (!noise) capture.noise.reset();
  return capture;
}

TEST(ColorEvidence, AutoKeepsBouncedLight) {
  const SyntheticSet truth = patches(.5F);
  const CapturePixels pixels = photograph(taken(), truth);
  for (const bool told : {false, true}) {
    const Capture capture = telling(taken(), told);
    EXPECT_LT(errorOf(Model::Auto, capture, pixels, truth),
              1.05 * std::min(errorOf(Model::Lambert, capture, pixels, truth),
                              errorOf(Model::Transport, capture, pixels, truth)))
        << "noise told: " << told;
  }
}

TEST(ColorEvidence, AutoStaysMatteWhereTheColoursAreWrong) {
  const SyntheticSet truth = patches(0);
  const CapturePixels pixels = photograph(taken(), truth);
  for (const bool told : {false, true}) {
    const Capture capture = telling(wrong(taken(), .04F), told);
    EXPECT_LT(errorOf(Model::Auto, capture, pixels, truth),
              1.05 * errorOf(Model::Lambert, capture, pixels, truth))
        << "noise told: " << told;
  }
}

TEST(ColorEvidence, SaysNothingWhereNothingTellsTheLightsApart) {
  const SyntheticSet set = patches(0);
  Capture few = taken();
  few.shots.pop_back();
  const CapturePixels pixels = photograph(few, set);
  EstimatorContext context{lightingFromCapture(few), noiseModel(kCamera, pixels, 0)};
  EXPECT_FALSE(colorUncertaintyByEvidence(context, {pixels, context.lighting, context.noise, {1, 1}}, .02F)
                   .has_value());

  Capture same = taken();
  for (Shot& shot : same.shots) shot.lightColors.assign(kLights, Rgb(.5F));
  const CapturePixels alike = photograph(same, set);
  context = {lightingFromCapture(same), noiseModel(kCamera, alike, 0)};
  EXPECT_FALSE(colorUncertaintyByEvidence(context, {alike, context.lighting, context.noise, {1, 1, 1}}, .02F)
                   .has_value());
}

}  // namespace
}  // namespace swaplight
