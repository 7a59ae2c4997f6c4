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

}  // namespace
}  // namespace swaplight
