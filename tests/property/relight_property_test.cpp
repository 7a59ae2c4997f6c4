#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/relight/relight.h"
#include "tests/property/arbitrary.h"

namespace swaplight {
namespace {

using test::anyFloat;
using test::anyInt;

Image anyPicture(int width, int height, std::mt19937& random) {
  Image image(ImageSpec::rgb(width, height));
  std::uniform_real_distribution<float> value(0, 4);
  for (int c = 0; c < 3; ++c)
    std::generate_n(image.plane(c), image.pixelCount(), [&] { return value(random); });
  return image;
}

SolvedSet anySet() {
  const int width = anyInt(1, 70), height = anyInt(1, 40), lights = anyInt(1, 9);
  std::mt19937 random(static_cast<unsigned>(anyInt(0, 1 << 20)));
  SolvedSet set;
  for (int i = 0; i < lights; ++i) {
    set.contributions.push_back(anyPicture(width, height, random));
    set.capture.lights.push_back({"light" + std::to_string(i), Role::Other, {}});
  }
  if (test::anyBool()) set.ambient = anyPicture(width, height, random);
  updateBeta(set);
  return set;
}

std::vector<Rgb> anyFactors(const SolvedSet& set) {
  std::vector<Rgb> factors;
  for (int i = 0; i < set.lightCount(); ++i) factors.push_back(anyInt(0, 3) ? test::anyRgb(5) : Rgb(0));
  return factors;
}

/// Whether a picture is `combined(channel, pixel)`, to a few roundings of its largest part.
template <typename Combined>
bool isNearly(const Image& image, const Combined& combined) {
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p) {
      const double expected = combined(c, p);
      if (!(std::abs(image.plane(c)[p] - expected) <= 3e-6 * (1 + expected))) return false;
    }
  return true;
}

RC_GTEST_PROP(Properties, RelightingIsLinearInTheRig, ()) {
  const SolvedSet set = anySet();
  const std::vector<Rgb> first = anyFactors(set), second = anyFactors(set);
  const float a = anyFloat(0, 3), b = anyFloat(0, 3);
  std::vector<Rgb> both;
  for (size_t i = 0; i < first.size(); ++i) both.push_back(a * first[i] + b * second[i]);
  const Image x = relight(set, first, a), y = relight(set, second, b),
              sum = relight(set, both, a * a + b * b);
  RC_ASSERT(
      isNearly(sum, [&](int c, size_t p) { return double(a) * x.plane(c)[p] + double(b) * y.plane(c)[p]; }));
}

RC_GTEST_PROP(Properties, TheLayersOfTheLightsAddUpToTheBeauty, ()) {
  const SolvedSet set = anySet();
  const std::vector<Rgb> factors = anyFactors(set);
  std::vector<Image> layers;
  for (size_t i = 0; i < factors.size(); ++i) {
    std::vector<Rgb> alone(factors.size(), Rgb(0));
    alone[i] = factors[i];
    layers.push_back(relight(set, alone, 0));
  }
  layers.push_back(relight(set, std::vector<Rgb>(factors.size(), Rgb(0)), 1));  // what no light explains
  RC_ASSERT(isNearly(relight(set, factors, 1), [&](int c, size_t p) {
    double sum = 0;
    for (const Image& layer : layers) sum += layer.plane(c)[p];
    return sum;
  }));
}

RC_GTEST_PROP(Properties, TheSharesOfAPixelAddUpToOne, ()) {
  const SolvedSet set = anySet();
  for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
    double sum = 0;
    for (int i = 0; i < set.lightCount(); ++i) sum += set.beta.plane(i)[p];
    RC_ASSERT(std::abs(sum - 1) < 1e-6);
  }
}

}  // namespace
}  // namespace swaplight
