#include "core/image/pixel_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "core/image/exr/exr_zip.h"
#include "core/image/half.h"
#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

constexpr int kWidth = 101;
constexpr int kHeight = 9;

std::vector<float> randomValues() {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> value(-.2F, 1.2F);
  std::vector<float> values(kWidth * kHeight);
  for (float& v : values) v = value(random);
  values[3] = NAN, values[4] = INFINITY, values[5] = -INFINITY, values[6] = 1e6F;
  return values;
}

/// What a value becomes in a file and back, by the header's words.
double expectedOf(float value, PixelType type) {
  if (type == PixelType::Float) return value;
  if (type == PixelType::Half) return roundedToHalf(value);
  const double steps = type == PixelType::UInt8 ? 255 : 65535;
  return std::isnan(value) ? 0 : std::floor(std::clamp(double(value), 0.0, 1.0) * steps + .5) / steps;
}

TEST(PixelPack, EveryTypeReturnsWhatItCanHoldAtEveryLevel) {
  const std::vector<float> values = randomValues();
  for (const PixelType type : {PixelType::UInt8, PixelType::UInt16, PixelType::Half, PixelType::Float})
    for (const size_t channels : {size_t{1}, size_t{3}}) {
      const PackedLayout layout(std::vector<PixelType>(channels, type));
      const std::vector<const float*> planes(channels, values.data());
      std::vector<std::byte> rows(layout.pixelBytes * values.size());
      std::vector<float> back(values.size());
      std::vector<float*> to(channels, nullptr);
      to.back() = back.data();
      // A product that was fused with the sum may round to the neighbouring step.
      const double step = type == PixelType::UInt8 ? 1.0 / 255 : type == PixelType::UInt16 ? 1.0 / 65535 : 0;
      test::atEveryLevel([&] {
        packPixels({planes, kWidth, kWidth, kHeight}, layout, rows.data());
        unpackPixels(rows.data(), layout, kWidth, 0, {to, kWidth, kWidth, kHeight});
        for (size_t p = 0; p < values.size(); ++p) {
          const double expected = expectedOf(values[p], type);
          if (std::isnan(expected))
            ASSERT_TRUE(std::isnan(back[p])) << p;
          else if (std::isinf(expected))
            ASSERT_EQ(back[p], expected) << p;
          else
            ASSERT_NEAR(back[p], expected, step * 1.001) << pixelTypeName(type) << ", value " << values[p];
        }
      });
    }
}

TEST(PixelPack, IntegersComeBackToTheBitAtEveryLevel) {
  std::vector<float> values;
  for (int i = 0; i < 65536; i += 13) values.push_back(float(i) / 65535.0F);
  std::vector<std::byte> bytes(values.size() * 2);
  std::vector<float> back(values.size());
  test::atEveryLevel([&] {
    packRow(values.data(), PixelType::UInt16, bytes.data(), int(values.size()));
    unpackRow(bytes.data(), PixelType::UInt16, back.data(), int(values.size()));
    EXPECT_EQ(back, values);
  });
}

TEST(Half, IsTheSameToTheBitAtEveryLevel) {
  std::vector<float> values;
  for (uint32_t bits = 0; bits < 0x7f800000U; bits += 54321) values.push_back(std::bit_cast<float>(bits));
  std::vector<uint16_t> halves(values.size());
  test::atEveryLevel([&] {
    halfFromFloat(values.data(), halves.data(), values.size());
    for (size_t i = 0; i < values.size(); ++i) ASSERT_EQ(halves[i], halfFromFloat(values[i])) << values[i];
    std::vector<float> back(values.size());
    floatFromHalf(halves.data(), back.data(), halves.size());
    for (size_t i = 0; i < values.size(); ++i) ASSERT_EQ(back[i], floatFromHalf(halves[i])) << values[i];
  });
}

TEST(ExrZip, PacksAndUnpacksTheSameBytesAtEveryLevel) {
  for (const size_t size : {size_t{64}, size_t{1001}, size_t{40000}}) {
    std::vector<std::byte> raw(size), back(size), first, packed;
    for (size_t i = 0; i < size; ++i) raw[i] = std::byte(i / 7 * (i % 2));
    test::atEveryLevel([&] {
      packExrZip(raw, packed);
      ASSERT_FALSE(packed.empty());
      if (first.empty()) first = packed;
      EXPECT_EQ(packed, first);
      ASSERT_TRUE(unpackExrZip(packed, back));
      EXPECT_EQ(back, raw);
    });
  }
}

}  // namespace
}  // namespace swaplight
