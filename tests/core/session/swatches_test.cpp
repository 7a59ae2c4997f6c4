#include "core/session/swatches.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/relight/setting.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;

LightColor colorOf(const std::string& text) {
  LightSetting setting;
  applySetting(setting, text);
  return setting.color;
}

std::vector<std::string> textsOf(const std::vector<LightColor>& colors) {
  std::vector<std::string> texts;
  for (const LightColor& color : colors) texts.push_back(colorText(color));
  return texts;
}

using Texts = std::vector<std::string>;

TEST(Swatches, AreThereAgainNewestFirst) {
  const TemporaryFolder folder;
  {
    Swatches swatches(folder / "state" / "colors.json");
    swatches.keep(colorOf("3200K,gel:L201"));
    swatches.keep(colorOf("#ff8040"));
    swatches.use(colorOf("rgb:4/1/0.5"));
    swatches.use(colorOf("5600K,green:+0.25"));
  }
  const Swatches again(folder / "state" / "colors.json");
  EXPECT_EQ(textsOf(again.kept()), (Texts{"#ff8040", "3200K,gel:L201"}));
  EXPECT_EQ(textsOf(again.recent()), (Texts{"5600K,green:+0.25", "rgb:4/1/0.5"}));
}

TEST(Swatches, HoldNoColourTwice) {
  const TemporaryFolder folder;
  Swatches swatches(folder / "colors.json");
  for (const char* text : {"#ff0000", "#00ff00", "#ff0000"}) swatches.use(colorOf(text));
  EXPECT_EQ(textsOf(swatches.recent()), (Texts{"#ff0000", "#00ff00"}));
  swatches.keep(colorOf("#ff0000"));
  swatches.keep(colorOf("#ff0000"));
  swatches.use(colorOf("#ff0000"));
  EXPECT_EQ(textsOf(swatches.kept()), Texts{"#ff0000"});
  EXPECT_EQ(textsOf(swatches.recent()), Texts{"#00ff00"});
  swatches.use({});  // white has a button
  EXPECT_EQ(swatches.recent().size(), 1);
  swatches.drop(colorOf("#ff0000"));
  EXPECT_TRUE(swatches.kept().empty());
}

TEST(Swatches, TheOldestGoes) {
  const TemporaryFolder folder;
  Swatches swatches(folder / "colors.json");
  for (size_t i = 0; i < 40; ++i) {
    const std::string text = std::to_string(2000 + 100 * i) + "K";
    swatches.use(colorOf(text));
    swatches.keep(colorOf("gel:none," + std::to_string(2050 + 100 * i) + "K"));
  }
  EXPECT_EQ(swatches.recent().size(), Swatches::kMostRecent);
  EXPECT_EQ(swatches.kept().size(), Swatches::kMostKept);
  EXPECT_EQ(colorText(swatches.kept().front()), "5950K");
}

TEST(Swatches, ABrokenFileIsAnEmptyOne) {
  const TemporaryFolder folder;
  for (const char* text :
       {"{", "[]", R"({"kept": ["nonsense"], "recent": []})", R"({"kept": [3], "recent": []})"}) {
    std::ofstream(folder / "colors.json") << text;
    const Swatches swatches(folder / "colors.json");
    EXPECT_TRUE(swatches.kept().empty() && swatches.recent().empty()) << text;
  }
}

}  // namespace
}  // namespace swaplight
