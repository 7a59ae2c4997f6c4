#pragma once

#include <random>
#include <string>

#include "core/base/json_fwd.h"
#include "core/set/solved_set.h"

namespace swaplight::test {

/// A solved set of random contributions: smooth shading times a texture, some pixels black, from a fixed
/// seed.
inline SolvedSet smallSet(int lights, int width, int height) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0, 1);
  SolvedSet set;
  for (int i = 0; i < lights; ++i) {
    set.capture.lights.push_back({"light" + std::to_string(i + 1), Role::Other, {}});
    set.contributions.emplace_back(ImageSpec::rgb(width, height));
  }
  Image albedo(ImageSpec::rgb(width, height));
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < albedo.pixelCount(); ++p)
      albedo.plane(c)[p] = p % 97 == 0 ? 0 : .1f + .8f * uniform(random);
  for (int i = 0; i < lights; ++i) {
    const float angle = 6.28f * static_cast<float>(i) / static_cast<float>(lights);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const float u = static_cast<float>(x) / static_cast<float>(width) - .5f;
        const float v = static_cast<float>(y) / static_cast<float>(height) - .5f;
        const float shading = std::max(0.f, .3f + u * std::cos(angle) + v * std::sin(angle));
        for (int c = 0; c < 3; ++c)
          set.contributions[static_cast<size_t>(i)].span().at(c, x, y) =
              shading * albedo.view().at(c, x, y) * (1 + .1f * static_cast<float>(c * i));
      }
  }
  ImageSpec beta{width, height, {}, "data"};
  set.beta = Image(beta);
  updateBeta(set);
  return set;
}

}  // namespace swaplight::test
