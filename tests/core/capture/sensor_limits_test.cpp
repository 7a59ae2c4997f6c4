#include "core/capture/sensor_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

Image noise(unsigned seed) {
  Image image(ImageSpec::rgb(97, 83));
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0, 3);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p) image.plane(c)[p] = value(random);
  return image;
}

TEST(SensorLimits, CountsPixelsTheSameAtEveryLevel) {
  Image image = noise(1);
  for (size_t p = 0; p < 50; ++p) image.plane(int(p % 3))[p * 31] = p % 2 ? NAN : INFINITY;
  for (size_t p = 0; p < 20; ++p) image.plane(1)[p * 31 + 7] = -.5F;
  image.plane(2)[4000] = 12;
  test::atEveryLevel([&] {
    const PixelCounts counts = countPixels(image, -.01F);
    EXPECT_EQ(counts.notFinite, 50U);
    EXPECT_EQ(counts.negative, 20U);
    EXPECT_EQ(counts.largest, 12.0F);
  });
}

TEST(SensorLimits, FindsThePileOfSaturatedPixelsAtEveryLevel) {
  std::vector<Image> shots;
  std::vector<PixelCounts> counts;
  for (const unsigned seed : {1U, 2U, 3U}) {
    Image& shot = shots.emplace_back(noise(seed));
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < shot.pixelCount(); ++p) shot.plane(c)[p] = std::min(shot.plane(c)[p], 2.5F);
    counts.push_back(countPixels(shot, 0));
  }
  test::atEveryLevel([&] { EXPECT_NEAR(floatClipLevel(shots, counts), 2.5F * .999F, 1e-4F); });
}

}  // namespace
}  // namespace swaplight
