#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/capture/capture_pixels.h"

namespace swaplight {

/// A set of random pixels with known contributions: albedo 0.05 .. 0.9, shading 0 .. 0.5 a light, and in 15 %
/// of the pixels a white highlight a light of mean `highlight` (docs/theory.md, Typical pixels).
struct SyntheticSet {
  int width = 128;
  int height = 64;
  std::vector<Image> truth;  ///< T, one a light

  SyntheticSet(int lights, float highlight, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    for (int i = 0; i < lights; ++i) truth.emplace_back(ImageSpec::rgb(width, height));
    for (size_t p = 0; p < truth.front().pixelCount(); ++p) {
      float albedo[3];
      for (float& a : albedo) a = 0.05F + 0.85F * unit(random);
      for (Image& t : truth) {
        const float shading = 0.5F * unit(random);
        const bool shiny = highlight > 0 && unit(random) < 0.15F;
        const float white = shiny ? -highlight * std::log(1 - unit(random)) : 0;
        for (int c = 0; c < 3; ++c) t.plane(c)[p] = shading * albedo[c] + white;
      }
    }
  }
};

inline const std::vector<Rgb>& defaultColors() {
  static const std::vector<Rgb> colors = {{.9F, .2F, .15F},  {.15F, .8F, .25F}, {.2F, .25F, .9F},
                                          {.85F, .75F, .1F}, {.1F, .75F, .8F},  {.75F, .15F, .8F},
                                          {.95F, .5F, .3F},  {.4F, .9F, .6F}};
  return colors;
}

/// Shot k gives light i the colour (i + k) mod N.
inline Capture rotatedCapture(int lights, const std::vector<Rgb>& colors = defaultColors()) {
  Capture capture;
  capture.name = "synthetic";
  for (int i = 0; i < lights; ++i) {
    capture.lights.push_back({"light" + std::to_string(i), Role::Other, {}});
    Shot shot;
    for (int j = 0; j < lights; ++j) shot.lightColors.emplace_back(colors[size_t((i + j) % lights)]);
    capture.shots.push_back(shot);
  }
  return capture;
}

/// Photographs the set; noise as given (none: exact).
inline CapturePixels photograph(const Capture& capture, const SyntheticSet& set, unsigned seed = 7) {
  std::mt19937 random(seed);
  std::normal_distribution<float> gauss;
  CapturePixels pixels;
  for (const Shot& shot : capture.shots) {
    Image image(ImageSpec::rgb(set.width, set.height), 0);
    const float exposure = std::exp2(shot.exposureStops);
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p) {
        float y = 0;
        for (size_t i = 0; i < set.truth.size(); ++i)
          y += exposure * (*shot.lightColors[i])[c] * set.truth[i].plane(c)[p];
        if (capture.noise)
          y += gauss(random) *
               float(std::sqrt(y / capture.noise->fullWell + capture.noise->read * capture.noise->read));
        image.plane(c)[p] = y;
      }
    pixels.shots.push_back(std::move(image));
    pixels.clipLevel.push_back(INFINITY);
    pixels.quantum.push_back(0);
  }
  return pixels;
}

}  // namespace swaplight
