#include "core/view/scopes/scope_scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace swaplight {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> textsOf(const std::vector<ScopeTick>& ticks) {
  std::vector<std::string> texts;
  for (const ScopeTick& tick : ticks) texts.push_back(tick.text);
  return texts;
}

DisplayLuminance luminanceOf(const char* display, const char* view) {
  return {ColorConfig(""), {display, view}};
}

TEST(ScopeScale, IsWrittenInTheUnit) {
  const DisplayLuminance shown;
  EXPECT_THAT(textsOf(scopeTicks(ScopeUnit::Codes8, shown)), ElementsAre("0", "64", "128", "192", "255"));
  EXPECT_THAT(textsOf(scopeTicks(ScopeUnit::Codes10, shown)), ElementsAre("0", "256", "512", "768", "1023"));
  EXPECT_THAT(textsOf(scopeTicks(ScopeUnit::Percent, shown)), ElementsAre("0", "25", "50", "75", "100"));
  EXPECT_FLOAT_EQ(scopeTicks(ScopeUnit::Codes10, shown)[1].place, 256.F / 1023);
}

TEST(ScopeScale, OfNitsLiesWhereTheDisplayShowsThem) {
  for (const auto& [display, view] : {std::pair("sRGB", "sRGB"), {"Rec.2100 PQ", "203 nit white"}}) {
    const DisplayLuminance shown = luminanceOf(display, view);
    const std::vector<ScopeTick> ticks = scopeTicks(ScopeUnit::Nits, shown);
    EXPECT_EQ(ticks.back().text, std::string(display) == "sRGB" ? "100" : "10000");
    for (size_t i = 0; i < ticks.size(); ++i) {
      EXPECT_NEAR(shown.nits(ticks[i].place), std::stof(ticks[i].text),
                  .01F + 1e-3F * std::stof(ticks[i].text));
      if (i > 0) {
        EXPECT_GT(ticks[i].place, ticks[i - 1].place + .05F);
      }
    }
  }
}

TEST(ScopeScale, IsPerCentWhereNitsAreNotKnown) {
  EXPECT_EQ(textsOf(scopeTicks(ScopeUnit::Nits, luminanceOf("sRGB", "Log"))),
            textsOf(scopeTicks(ScopeUnit::Percent, {})));
}

}  // namespace
}  // namespace swaplight
