// What the viewer's shader does to a pixel, compiled as C++ through GLM, against the processor's way.
#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <limits>
#include <random>

#include "core/view/display/display_table.h"
#include "core/view/display/false_color.h"
#include "core/view/display/zebra.h"

namespace swaplight {
namespace shader {

using namespace glm;  // NOLINT(google-build-using-namespace): GLSL's own names
#include "shaders/view_math.glsl"

}  // namespace shader

namespace {

std::vector<Rgb> someColors() {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> level(-0.1F, 1.2F);
  std::vector<Rgb> colors;
  colors.reserve(500);
  for (int i = 0; i < 500; ++i) colors.emplace_back(level(random), level(random), level(random));
  return colors;
}

TEST(ViewMath, ExposureGammaAndChannelAreTheTables) {
  for (const ViewChannel channel :
       {ViewChannel::Color, ViewChannel::Red, ViewChannel::Green, ViewChannel::Blue, ViewChannel::Luminance})
    for (const float gamma : {1.0F, 0.6F, 2.2F}) {
      ViewSettings settings;
      settings.exposureStops = -0.5F;
      settings.gamma = gamma;
      settings.channel = channel;
      const DisplayTable table(nullptr, settings);
      for (const Rgb& color : someColors()) {
        std::array<uint8_t, 4> codes{};
        table.apply(&color.r, &color.g, &color.b, 1, codes.data());
        const glm::vec3 shown = shader::pickedChannel(
            shader::withGamma(shader::exposed(color, std::exp2(-0.5F)), gamma), static_cast<int>(channel));
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(255 * shown[c], codes[static_cast<size_t>(c)], 1.01);
      }
    }
}

TEST(ViewMath, ValuesThatAreNotFiniteBecomeSo) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(shader::exposed({std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}, 1),
            glm::vec3(0, 65504, -65504));
}

TEST(ViewMath, StopsAreThoseOfTheFalseColours) {
  EXPECT_FLOAT_EQ(shader::stopsFromGrey(glm::vec3(0.36F), kRec709Luminance), 1);
  EXPECT_LT(shader::stopsFromGrey(glm::vec3(-1), kRec709Luminance), falseColorBands()[1].stops);
  EXPECT_LT(shader::stopsFromGrey(glm::vec3(0), kRec709Luminance), falseColorBands()[1].stops);
}

TEST(ViewMath, ZebraStripesTheSamePixels) {
  constexpr int kSide = 40;
  const Zebra zebra{true, 0.2F, 0.8F};
  std::mt19937 random(4);
  std::vector<uint8_t> pixels(4 * kSide * kSide, 255);
  for (size_t i = 0; i < pixels.size(); ++i)
    if (i % 4 != 3) pixels[i] = static_cast<uint8_t>(random() % 256 / (1 + i / 4 % 7));
  std::vector<uint8_t> striped = pixels;
  drawZebra(zebra, kSide, kSide, striped.data());
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const size_t at = 4 * (static_cast<size_t>(y) * kSide + static_cast<size_t>(x));
      const glm::vec3 code = glm::vec3(pixels[at], pixels[at + 1], pixels[at + 2]) / 255.0F;
      const glm::vec3 shown = shader::withZebra(code, zebra.low, zebra.high, x, y);
      for (size_t c = 0; c < 3; ++c)
        ASSERT_NEAR(255 * shown[static_cast<int>(c)], striped[at + c], 0.51) << x << " " << y;
    }
}

}  // namespace
}  // namespace swaplight
