#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/lamp/gel.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

TEST(GelImport, AnImportedTableIsThereAtOnceAndNextTime) {
  const test::TemporaryFolder folder;
  setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
  const std::vector<Gel>& before = allGels();
  const size_t count = before.size();
  test::writeBytes(folder / "mine.csv", "brand,number,name,x,y,T\nHouse,7,Dusk,0.35,0.25,0.4\n");
  EXPECT_EQ(importGels(folder / "mine.csv"), 1U);
  EXPECT_EQ(allGels().size(), count + 1);
  EXPECT_EQ(before.size(), count);  // still valid for whoever holds it
  const auto named = [](const Gel& gel) { return gel.name == "Dusk"; };
  EXPECT_TRUE(std::any_of(allGels().begin(), allGels().end(), named));
  EXPECT_TRUE(std::filesystem::exists(folder / "swaplight" / "gels" / "mine.csv"));
  test::writeBytes(folder / "bad.csv", "brand,number,name,x,y,T\nHouse,8,Dusk,none,0.25,0.4\n");
  EXPECT_FALSE(test::inputError([&] { importGels(folder / "bad.csv"); }).empty());
  EXPECT_EQ(allGels().size(), count + 1);
  unsetenv("XDG_DATA_HOME");
}

TEST(GelImport, AMeasuredGelIsAmongTheGelsAtOnceAndNotTwice) {
  const test::TemporaryFolder folder;
  setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
  const Gel first = addMeasuredGel({"House", "901", "Brick"}, {.6F, .2F, .1F});
  EXPECT_EQ(first.source, Gel::Source::Measured);
  EXPECT_NEAR(first.filter.g / first.filter.r, 1 / 3.0, 1e-3);
  const Gel second = addMeasuredGel({"House", "902", "Sea"}, {.1F, .3F, .5F});
  EXPECT_EQ(findGel(first.id).name, "Brick");
  EXPECT_EQ(findGel(second.id).name, "Sea");
  EXPECT_NE(test::inputError([] {
              addMeasuredGel({"House", "901", "Brick"}, {.6F, .2F, .1F});
            }).find("already"),
            std::string::npos);
  EXPECT_FALSE(test::inputError([] { addMeasuredGel({"House", "903", "None"}, {0, 0, 0}); }).empty());
  EXPECT_FALSE(test::inputError([] { addMeasuredGel({" ", "904", "None"}, {.5F, .2F, .1F}); }).empty());
  EXPECT_NE(test::inputError([] {
              addMeasuredGel({" House ", "901", "Brick"}, {.6F, .2F, .1F});
            }).find("already"),
            std::string::npos);
  EXPECT_EQ(findGel(second.id).name, "Sea") << "what is refused leaves a table that can be read";
  // Another table's number would be found in place of it; and one of that name would replace it.
  test::writeBytes(folder / "lee.csv", "brand,number,name,x,y,T\nHouse,905,Maker,0.35,0.25,0.4\n");
  importGels(folder / "lee.csv");
  EXPECT_FALSE(test::inputError([] { addMeasuredGel({"House", "905", "Own"}, {.6F, .2F, .1F}); }).empty());
  test::writeBytes(folder / "measured.csv", "brand,number,name,x,y,T\nHouse,906,Dusk,0.35,0.25,0.4\n");
  EXPECT_FALSE(test::inputError([&] { importGels(folder / "measured.csv"); }).empty());
  unsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace swaplight
