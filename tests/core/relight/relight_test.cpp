#include "core/relight/relight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/json.h"

namespace swaplight {
namespace {

SolvedSet randomSet(int lights, int width, int height, bool ambient, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0, 2);
  const auto picture = [&] {
    Image image(ImageSpec::rgb(width, height));
    for (int c = 0; c < 3; ++c)
      std::generate_n(image.plane(c), image.pixelCount(), [&] { return value(random); });
    return image;
  };
  SolvedSet set;
  for (int i = 0; i < lights; ++i) {
    set.contributions.push_back(picture());
    set.capture.lights.push_back({"light" + std::to_string(i), Role::Other, Json::object()});
  }
  if (ambient) set.ambient = picture();
  updateBeta(set);
  return set;
}

std::vector<Rgb> randomFactors(int lights, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0, 3);
  std::vector<Rgb> factors;
  for (int i = 0; i < lights; ++i) factors.emplace_back(value(random), value(random), value(random));
  return factors;
}

/// The largest difference, relative to the larger value and 1.
double difference(const Image& a, const Image& b) {
  double worst = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p) {
      const double x = a.plane(c)[p];
      const double y = b.plane(c)[p];
      worst = std::max(worst, std::fabs(x - y) / std::max({1.0, std::fabs(x), std::fabs(y)}));
    }
  return worst;
}

class RelightOfLights : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Counts, RelightOfLights, testing::Values(1, 2, 3, 4, 5, 8, 9, 16));

TEST_P(RelightOfLights, IsTheWeightedSum) {
  const int lights = GetParam();
  const SolvedSet set = randomSet(lights, 37, 70, true);
  const std::vector<Rgb> factors = randomFactors(lights, 3);
  const Image out = relight(set, factors, 0.5f);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < out.pixelCount(); ++p) {
      double expected = 0.5 * set.ambient->plane(c)[p];
      for (size_t i = 0; i < factors.size(); ++i)
        expected += double{factors[i][c]} * set.contributions[i].plane(c)[p];
      ASSERT_NEAR(out.plane(c)[p], expected, 1e-6 * lights * (1 + expected));
    }
}

TEST_P(RelightOfLights, OfAllLightsAtUnitWhiteIsTheSetUnderWhite) {
  const SolvedSet set = randomSet(GetParam(), 33, 20, true);
  EXPECT_LE(difference(relight(set, std::vector<Rgb>(set.contributions.size(), Rgb(1))), sumAtUnitWhite(set)),
            1e-6);
}

TEST_P(RelightOfLights, OfASumOfLightingsIsTheSumOfThePictures) {
  const int lights = GetParam();
  const SolvedSet set = randomSet(lights, 31, 17, false);
  const std::vector<Rgb> a = randomFactors(lights, 5);
  const std::vector<Rgb> b = randomFactors(lights, 6);
  std::vector<Rgb> both = a;
  for (size_t i = 0; i < both.size(); ++i) both[i] += b[i];
  Image sum = relight(set, a);
  const Image rest = relight(set, b);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < sum.pixelCount(); ++p) sum.plane(c)[p] += rest.plane(c)[p];
  EXPECT_LE(difference(sum, relight(set, both)), 2e-6);
}

TEST_P(RelightOfLights, DoesNotDependOnTheirOrder) {
  const int lights = GetParam();
  const std::vector<Rgb> factors = randomFactors(lights, 9);
  const SolvedSet set = randomSet(lights, 19, 23, true);
  SolvedSet reversed = randomSet(lights, 19, 23, true);
  std::reverse(reversed.contributions.begin(), reversed.contributions.end());
  const std::vector<Rgb> reversedFactors(factors.rbegin(), factors.rend());
  EXPECT_LE(difference(relight(set, factors), relight(reversed, reversedFactors)), 2e-6);
}

TEST_P(RelightOfLights, AtTwiceTheLightIsTwiceAsBright) {
  const int lights = GetParam();
  const SolvedSet set = randomSet(lights, 40, 9, true);
  std::vector<Rgb> factors = randomFactors(lights, 11);
  Image twice = relight(set, factors, 1);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < twice.pixelCount(); ++p) twice.plane(c)[p] *= 2;
  for (Rgb& factor : factors) factor *= 2;
  EXPECT_EQ(difference(twice, relight(set, factors, 2)), 0) << "a power of two is exact";
}

TEST(Relight, OfLightsThatAreOffIsBlackWhateverTheirPicturesHold) {
  SolvedSet set = randomSet(2, 8, 8, false);
  set.contributions[0].plane(0)[5] = NAN;
  const Image out = relight(set, std::vector<Rgb>(2, Rgb(0)));
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < out.pixelCount(); ++p) ASSERT_EQ(out.plane(c)[p], 0);
}

TEST(Relight, WritesIntoAPartOfALargerPicture) {
  const SolvedSet set = randomSet(3, 12, 7, false);
  const std::vector<Rgb> factors = randomFactors(3, 2);
  Image canvas(ImageSpec::rgb(40, 30), -1);
  relight(set, factors, 1, canvas.span().crop(5, 6, 12, 7));
  const Image expected = relight(set, factors);
  EXPECT_EQ(canvas.view().at(1, 4, 6), -1);
  EXPECT_EQ(canvas.view().at(1, 17, 6), -1);
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 12; ++x) ASSERT_EQ(canvas.view().at(c, 5 + x, 6 + y), expected.view().at(c, x, y));
}

TEST(Relight, KeepsTheColorSpaceOfTheSet) {
  SolvedSet set = randomSet(1, 2, 2, false);
  set.contributions[0].setColorSpace("acescg");
  EXPECT_EQ(relight(set, std::vector<Rgb>{Rgb(1)}).spec().colorSpace, "acescg");
}

TEST(Relight, RefusesFactorsOrAPictureThatDoNotFit) {
  const SolvedSet set = randomSet(2, 4, 4, false);
  EXPECT_THROW(static_cast<void>(relight(set, std::vector<Rgb>(3))), std::logic_error);
  Image small(ImageSpec::rgb(3, 4));
  EXPECT_THROW(relight(set, std::vector<Rgb>(2), 1, small.span()), std::logic_error);
}

}  // namespace
}  // namespace swaplight
