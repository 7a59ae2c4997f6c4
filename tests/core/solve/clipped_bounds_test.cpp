#include "core/solve/clipped_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kLights = 3;
constexpr size_t kPixel = 20 * 128 + 30;
constexpr size_t kLamp = 1;

/// A surface that one lamp alone lights: red is clipped wherever that lamp is on. `trace`: of its red in
/// every photograph, bounced light that the colours do not explain.
CapturePixels clippedRed(const Capture& capture, float red, float trace) {
  SyntheticSet truth(kLights, 0);
  for (size_t i = 0; i < kLights; ++i)
    for (int c = 0; c < 3; ++c)
      truth.truth[i].plane(c)[kPixel] = i != kLamp ? 0 : c == 0 ? red : .6F / float(c);
  CapturePixels pixels = photograph(capture, truth);
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    pixels.clipLevel[k] = .9999F;
    Image& shot = pixels.shots[k];
    shot.plane(0)[kPixel] += trace;
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < shot.pixelCount(); ++p) shot.plane(c)[p] = std::min(shot.plane(c)[p], 1.0F);
  }
  return pixels;
}

Capture allOnOneOff() {
  Capture capture = rotatedCapture(kLights);
  for (size_t k = 0; k < kLights; ++k)
    for (size_t i = 0; i < kLights; ++i) capture.shots[k].lightColors[i] = Rgb(i == k ? 0.0F : 1.0F);
  return capture;
}

SolvedSet solvedBy(Model model, const Capture& capture, const CapturePixels& pixels) {
  SolveOptions options;
  options.model = model;
  return solve(capture, pixels, options);
}

TEST(ClippedBounds, ATraceWhereTheLampIsOffIsNoBrightLight) {
  const Capture capture = allOnOneOff();
  for (const float trace : {0.0F, 3e-4F, 2e-3F})
    for (const Model model : {Model::Auto, Model::Lambert, Model::Transport, Model::Gloss}) {
      const SolvedSet set = solvedBy(model, capture, clippedRed(capture, 3, trace));
      EXPECT_LT(set.contributions[kLamp].plane(0)[kPixel], 5) << int(model) << ' ' << trace;
      EXPECT_GT(set.contributions[kLamp].plane(0)[kPixel], .95F) << int(model) << ' ' << trace;
      EXPECT_NEAR(set.contributions[kLamp].plane(1)[kPixel], .6F, .05F) << int(model) << ' ' << trace;
      EXPECT_GT(set.quality.plane(kSigma)[kPixel], .1F) << int(model) << ' ' << trace;
    }
}

TEST(ClippedBounds, WhatAWeakGelLetsThroughCounts) {
  Capture capture = rotatedCapture(kLights);
  for (size_t k = 0; k < kLights; ++k)
    capture.shots[k].lightColors[kLamp] = k == 2 ? Rgb(.03F, .5F, .9F) : Rgb(.9F, .5F, .2F);
  const SolvedSet set = solvedBy(Model::Lambert, capture, clippedRed(capture, 3, 0));
  EXPECT_NEAR(set.contributions[kLamp].plane(0)[kPixel], 3, .1F);
}

TEST(ClippedBounds, AShotThatTheOthersContradictIsNotBelieved) {
  LightingMatrix lighting;
  lighting.lights = 2;
  lighting.shots = 3;
  lighting.colors = {Rgb(1), Rgb(.5F), Rgb(1), Rgb(0), Rgb(0), Rgb(1)};
  CapturePixels pixels;
  for (const float value : {1.0F, .3F, .2F}) {  // the first one should be .4: somebody opened a door
    pixels.shots.emplace_back(ImageSpec::rgb(1, 1), value);
    pixels.clipLevel.push_back(.9999F);
    pixels.quantum.push_back(0);
  }
  const std::vector<float> exposure{1, 1, 1};
  const ShotSignal signal(pixels, lighting, {1e-6F, 0, 0}, exposure);
  SolvedSet set;
  for (const float light : {.3F, .2F}) set.contributions.emplace_back(ImageSpec::rgb(1, 1), light);
  set.quality = Image({1, 1, {"residual", "sigma", "flags", "model"}, "data"}, 0);
  EXPECT_EQ(keepWithinClippedBounds({lighting, {1e-6F, 0, 0}}, exposure, signal, .03, set), 0U);
  EXPECT_EQ(set.contributions[0].plane(0)[0], .3F);
}

TEST(ClippedBounds, AShorterExposureSaysAnyBrightness) {
  LightingMatrix lighting;
  lighting.lights = 1;
  lighting.shots = 2;
  lighting.colors = {Rgb(1), Rgb(1 / 1024.F)};
  CapturePixels pixels;
  for (const float value : {1.0F, .3F}) {
    pixels.shots.emplace_back(ImageSpec::rgb(1, 1), value);
    pixels.clipLevel.push_back(.9999F);
    pixels.quantum.push_back(0);
  }
  const std::vector<float> exposure{1, 1 / 1024.F};
  const ShotSignal signal(pixels, lighting, {1e-6F, 0, 0}, exposure);
  SolvedSet set;
  set.contributions.emplace_back(ImageSpec::rgb(1, 1), .3F * 1024);
  set.quality = Image({1, 1, {"residual", "sigma", "flags", "model"}, "data"}, 0);
  EXPECT_EQ(keepWithinClippedBounds({lighting, {}}, exposure, signal, .03, set), 0U);
  EXPECT_FLOAT_EQ(set.contributions[0].plane(0)[0], .3F * 1024);
  EXPECT_EQ(keepWithinClippedBounds({lighting, {}}, {1, 1}, signal, .03, set), 1U)
      << "were the lamp itself that weak";
}

}  // namespace
}  // namespace swaplight
