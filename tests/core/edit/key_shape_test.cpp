#include "core/edit/shapes/key_shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/base/json.h"
#include "core/color/srgb.h"
#include "core/edit/apply/edited_set.h"
#include "core/edit/mask/mask.h"
#include "core/ocio/chosen_config.h"
#include "core/set/set_color_space.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

constexpr int kSide = 100;
constexpr Rgb kScreen{.02F, .45F, .06F}, kSkin{.5F, .3F, .22F};

/// A green screen on the left, skin on the right, half way between in the middle column; two lights, of which
/// the first gives three quarters.
SolvedSet screenAndSkin() {
  SolvedSet set = test::smallSet(2, kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const Rgb codes = .5F * (srgbFromLinear(kScreen) + srgbFromLinear(kSkin));
      const Rgb light = x < kSide / 2 ? kScreen : x > kSide / 2 ? kSkin : linearFromSrgb(codes);
      for (int c = 0; c < 3; ++c) {
        set.contributions[0].span().at(c, x, y) = .75F * light[c];
        set.contributions[1].span().at(c, x, y) = .25F * light[c];
      }
    }
  updateBeta(set);
  return set;
}

KeyShape screenKey() {
  KeyShape key;
  key.color = srgbFromLinear(kScreen);
  return key;
}

/// As shaders/filters/key/chroma-key.fs has it.
float chromaMatte(const Rgb& codes, const KeyShape& key) {
  const auto chroma = [](const Rgb& c) {
    const float y = .299F * c.r + .587F * c.g + .114F * c.b;
    return glm::vec2((c.b - y) / 1.772F, (c.r - y) / 1.402F);
  };
  return std::clamp((glm::length(chroma(codes) - chroma(key.color)) - key.from) / (key.to - key.from), 0.F,
                    1.F);
}

TEST(KeyShape, LetsThroughWhatIsNotTheScreen) {
  const SolvedSet set = screenAndSkin();
  KeyShape key = screenKey();
  MaskRaster matte = key.draw(set);
  EXPECT_EQ(matte.at(10, 70), 0);
  EXPECT_EQ(matte.at(90, 70), 1);
  key.to = .6F;  // a ramp so long that the middle lies on it
  matte = key.draw(set);
  const float half = chromaMatte(.5F * (srgbFromLinear(kScreen) + srgbFromLinear(kSkin)), key);
  EXPECT_GT(half, .05F);
  EXPECT_LT(half, .95F);
  EXPECT_NEAR(matte.at(kSide / 2, 70), half, 1e-4F);
}

TEST(KeyShape, IsTakenUnderTheLightsThatWereOn) {
  const SolvedSet set = screenAndSkin();
  KeyShape key = screenKey();
  key.lights = {{"light1", Rgb(0)}, {"light2", Rgb(4)}};  // the same picture, lit by the second alone
  EXPECT_EQ(key.draw(set).at(10, 10), 0);
  EXPECT_EQ(key.draw(set).at(90, 10), 1);
  key.lights = {{"light1", Rgb(1, 0, 1)}, {"light2", Rgb(1, 0, 1)}};  // no green light: no green screen
  EXPECT_EQ(key.draw(set).at(10, 10), 1);
}

TEST(KeyShape, ByLumaLetsThroughWhatIsBright) {
  const SolvedSet set = screenAndSkin();
  KeyShape key;
  key.by = KeyShape::By::Luma;
  key.from = .45F;
  key.to = .6F;
  const Rgb screen = srgbFromLinear(kScreen), skin = srgbFromLinear(kSkin);
  const auto expected = [&](const Rgb& c) {
    const float t = std::clamp((.299F * c.r + .587F * c.g + .114F * c.b - .45F) / .15F, 0.F, 1.F);
    return t * t * (3 - 2 * t);
  };
  EXPECT_NEAR(key.draw(set).at(10, 10), expected(screen), 1e-4F);
  EXPECT_NEAR(key.draw(set).at(90, 10), expected(skin), 1e-4F);
  EXPECT_GT(expected(skin), expected(screen) + .1F);
}

TEST(KeyShape, IsTheSameInOtherPrimaries) {
  const SolvedSet set = screenAndSkin();
  KeyShape key = screenKey();
  key.to = .6F;
  const MaskRaster here = key.draw(set);
  const MaskRaster there = key.draw(copyInColorSpace(*sessionConfig({}), set, "acescg"));
  for (const int x : {10, kSide / 2, 90}) EXPECT_NEAR(there.at(x, 30), here.at(x, 30), 2e-3F) << x;
}

TEST(KeyShape, ComesBackFromAFile) {
  const Json json = Json::parse(
      R"([{"shape": "key", "by": "luma", "color": [0.25, 0.5, 0.75], "from": 0.125, "to": 0.5,
           "lights": {"fill": [0.5, 0.25, 0], "key": [2, 1, 0]}, "ambient": 0.5, "invert": true}])");
  const Mask mask = maskFromJson(json, 9, 9, "x");
  const KeyShape key{
      KeyShape::By::Luma, {.25F, .5F, .75F}, .125F, .5F, {{"key", {2, 1, 0}}, {"fill", {.5F, .25F, 0}}}, .5F};
  EXPECT_EQ(mask, (Mask{{key, true}}));
  EXPECT_EQ(jsonFromMask(mask), json);
}

TEST(KeyShape, BadValuesAreOneLine) {
  const auto error = [](const char* more) {
    const std::string text = std::string(R"([{"shape": "key")") + more + "}]";
    return test::inputError([&] { static_cast<void>(maskFromJson(Json::parse(text), 9, 9, "edit 1")); });
  };
  EXPECT_THAT(error(R"(, "color": [0, 2, 0])"), HasSubstr("from 0 to 1"));
  EXPECT_THAT(error(R"(, "color": "green")"), HasSubstr("expected [r, g, b]"));
  EXPECT_THAT(error(R"(, "by": "hue")"), HasSubstr("chroma"));
  EXPECT_THAT(error(R"(, "from": 3)"), HasSubstr("from"));
  EXPECT_THAT(error(R"(, "lights": [1])"), HasSubstr("an object"));
  EXPECT_THAT(error(R"(, "lights": {"key": [1, -1, 1]})"), HasSubstr("key is 1 -1 1"));
  EXPECT_THAT(error(R"(, "lights": {"key": [1, 1e99, 1]})"), HasSubstr("factors"));
}

TEST(KeyShape, NamesLightsOfTheSetAndThoseThatEditsAdd) {
  const SolvedSet set = screenAndSkin();
  const auto edited = [&](const std::string& shape) {
    const std::string text =
        R"({"new_lights": ["sun"], "edits": [{"operation": "gain", "mask": [)" + shape + "]}]}";
    return applyEdits(set, editStackFromJson(Json::parse(text), kSide, kSide));
  };
  const auto error = [&](const std::string& shape) {
    return test::inputError([&] { static_cast<void>(edited(shape)); });
  };
  const std::string unknown = R"({"shape": "key", "lights": {"light2": [1, 1, 1], "lihgt1": [1, 1, 1]}})";
  EXPECT_EQ(error(unknown),
            "edit \"gain\": the key of its mask: there is no light \"lihgt1\"; the lights are light1, "
            "light2, sun");
  EXPECT_THAT(error(R"({"shape": "selection", "parts": [)" + unknown + "]}"),
              HasSubstr("no light \"lihgt1\""));
  EXPECT_EQ(edited(R"({"shape": "key", "lights": {"light1": [1, 1, 1], "sun": [2, 2, 2]}})").lightCount(), 3);
}

}  // namespace
}  // namespace swaplight
