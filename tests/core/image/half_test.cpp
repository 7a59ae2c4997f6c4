#include "core/image/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace swaplight {
namespace {

std::vector<uint16_t> everyHalf() {
  std::vector<uint16_t> halves(65536);
  for (size_t i = 0; i < halves.size(); ++i) halves[i] = static_cast<uint16_t>(i);
  return halves;
}

TEST(Half, EveryHalfSurvivesTheWayToFloatAndBack) {
  const std::vector<uint16_t> halves = everyHalf();
  std::vector<float> floats(halves.size());
  std::vector<uint16_t> back(halves.size());
  floatFromHalf(halves.data(), floats.data(), halves.size());
  halfFromFloat(floats.data(), back.data(), floats.size());
  for (size_t i = 0; i < halves.size(); ++i) {
    if (std::isnan(floats[i]))
      EXPECT_EQ(back[i] & 0x7c00, 0x7c00) << i;
    else
      ASSERT_EQ(halves[i], back[i]) << floats[i];
  }
}

TEST(Half, OneAtATimeGivesTheSameAsMany) {
  std::vector<float> floats;
  for (uint32_t bits = 0; bits < 0xfff00000U; bits += 77777) {
    float value = 0;
    memcpy(&value, &bits, 4);
    if (!std::isnan(value)) floats.push_back(value);
  }
  std::vector<uint16_t> many(floats.size());
  halfFromFloat(floats.data(), many.data(), floats.size());
  for (size_t i = 0; i < floats.size(); ++i) {
    uint16_t one = 0;
    halfFromFloat(&floats[i], &one, 1);
    ASSERT_EQ(one, many[i]) << floats[i];
    float wide = 0, wideMany[8]{};
    floatFromHalf(&one, &wide, 1);
    const std::vector<uint16_t> eight(8, one);
    floatFromHalf(eight.data(), wideMany, 8);
    ASSERT_EQ(wide, wideMany[3]);
  }
}

TEST(Half, KnownValues) {
  const float in[] = {1.0F,     -2.0F,    65504.0F,        65520.0F,
                      0x1p-24F, 0x1p-25F, 1.0F + 0x1p-11F, 1.0F + 0x1.8p-10F};
  const uint16_t expected[] = {0x3c00, 0xc000, 0x7bff, 0x7c00, 0x0001, 0x0000, 0x3c00, 0x3c02};
  for (size_t i = 0; i < std::size(in); ++i) {
    uint16_t half = 0;
    halfFromFloat(&in[i], &half, 1);
    EXPECT_EQ(half, expected[i]) << in[i];
  }
}

TEST(Half, OnlyFiniteValuesAreClampedWhereInfinitiesAreToStay) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(finiteClampedToHalf(1e6F), 65504);
  EXPECT_EQ(finiteClampedToHalf(-std::numeric_limits<float>::max()), -65504);
  EXPECT_EQ(finiteClampedToHalf(-0.25F), -0.25F);
  EXPECT_EQ(finiteClampedToHalf(kInfinity), kInfinity);
  EXPECT_EQ(finiteClampedToHalf(-kInfinity), -kInfinity);
  EXPECT_TRUE(std::isnan(finiteClampedToHalf(NAN)));
}

}  // namespace
}  // namespace swaplight
