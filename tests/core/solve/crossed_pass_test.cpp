#include "core/solve/highlights/crossed_pass.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

constexpr int kSize = 192;
const Rgb kPass{0.45F, 0.43F, 0.4F};

/// Two lights, both lightings open and crossed; `sheen`: the largest part of the light that is a highlight's,
/// less and less from left to right and none in the last `matte` of the picture.
struct Crossed {
  Capture capture = rotatedCapture(2);
  CapturePixels pixels;

  Crossed(float sheen, float matte, float ambient = 0) {
    for (int k = 0; k < 2; ++k) {
      capture.shots.push_back(capture.shots[static_cast<size_t>(k)]);
      capture.shots.back().crossed = true;
    }
    std::mt19937 random(5);
    std::normal_distribution<float> gauss;
    std::uniform_real_distribution<float> paint(0.1F, 0.9F);
    std::vector<float> albedo(kSize * kSize);
    for (float& one : albedo) one = paint(random);
    for (const Shot& shot : capture.shots) {
      Image image(ImageSpec::rgb(kSize, kSize));
      for (int c = 0; c < 3; ++c)
        for (int y = 0; y < kSize; ++y)
          for (int x = 0; x < kSize; ++x) {
            const float along = (float(x) + 0.5F) / kSize;
            const float light = (*shot.lightColors[0])[c] * along + (*shot.lightColors[1])[c] * (1 - along);
            const float mirrored = sheen * std::max(0.0F, 1 - along / (1 - matte));
            float value = light * albedo[static_cast<size_t>(y * kSize + x)] * 0.5F + ambient;
            value *= shot.crossed ? kPass[c] : 1 / (1 - mirrored);
            image.span().at(c, x, y) = value + 0.002F * gauss(random);
          }
      pixels.shots.push_back(std::move(image));
      pixels.clipLevel.push_back(INFINITY);
      pixels.quantum.push_back(0);
    }
    if (ambient > 0) pixels.ambient.emplace(ImageSpec::rgb(kSize, kSize), ambient);
  }
};

void expectPass(const CrossedPass& pass, const char* what) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(pass.part[c], kPass[c], 0.01 * double(kPass[c])) << what << " " << c;
  EXPECT_FALSE(pass.reversed) << what;
}

TEST(CrossedPass, IsFoundWhereSomethingIsMatte) {
  for (const auto& [what, sheen, matte] : {std::tuple{"all matte", 0.0F, 1.0F},
                                           {"half of it gleams a little", 0.2F, 0.5F},
                                           {"most of it gleams", 0.7F, 0.2F}}) {
    const Crossed shots(sheen, std::min(matte, 0.99F));
    expectPass(crossedPass(shots.capture, shots.pixels), what);
  }
}

TEST(CrossedPass, IsOfTheLightThatThePhotographsShareWithAmbientLightInIt) {
  const Crossed shots(0.3F, 0.4F, 0.1F);
  expectPass(crossedPass(shots.capture, shots.pixels), "ambient");
}

TEST(CrossedPass, ALightingMayBeTheSumOfOthers) {
  Crossed shots(0.3F, 0.4F);
  // The second crossed shot is gone, the first is of both lamps' colours mixed half and half.
  shots.capture.shots.pop_back();
  Image mixed = shots.pixels.shots[2].clone();
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < mixed.pixelCount(); ++p)
      mixed.plane(c)[p] = (mixed.plane(c)[p] + shots.pixels.shots[3].plane(c)[p]) / 2;
  shots.pixels.shots.resize(2);
  shots.pixels.shots.push_back(std::move(mixed));
  for (std::optional<Rgb>& color : shots.capture.shots[2].lightColors)
    color = (*shots.capture.shots[0].lightColors[0] + *shots.capture.shots[0].lightColors[1]) * 0.5F;
  expectPass(crossedPass(shots.capture, shots.pixels), "mixed");
}

TEST(CrossedPass, MarksTheWrongWayRoundAreNoticed) {
  Crossed shots(0.5F, 0.4F);
  for (Shot& shot : shots.capture.shots) shot.crossed = !shot.crossed;
  EXPECT_TRUE(crossedPass(shots.capture, shots.pixels).reversed);
}

TEST(CrossedPass, CannotBeToldOfOtherLightings) {
  Crossed shots(0, 0.9F);
  shots.capture.shots.erase(shots.capture.shots.begin());
  shots.pixels.shots.erase(shots.pixels.shots.begin());
  shots.capture.shots.erase(shots.capture.shots.begin() + 2);
  shots.pixels.shots.resize(2);
  try {
    static_cast<void>(crossedPass(shots.capture, shots.pixels));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("take each lighting twice"));
  }
}

}  // namespace
}  // namespace swaplight
