#include "core/chart/chart_colors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/image/io/image_io.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/made_chart.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

TEST(ChartColors, OneChartThatCannotBeReadLosesNoOther) {
  const test::TemporaryFolder folder;
  test::MadeChart made;
  writeImage(made.photograph(), folder.path() / "shot.exr");
  writeImage(made.photograph(), folder.path() / "chart_key.exr");
  writeImage(Image({90, 64, {"R", "G", "B"}, "lin_rec709"}, .2F), folder.path() / "chart_wall.exr");
  const ShotFolder found = scanShotFolder(test::builtinColors(), folder.path());
  EXPECT_THAT(found.charts, testing::ElementsAre("chart_key.exr", "chart_wall.exr"));
  EXPECT_THROW((void)chartColors(test::builtinColors(), found, "lin_rec709", found.charts), InputError);

  std::vector<std::string> wrong;
  const auto colors = chartColors(test::builtinColors(), found, "lin_rec709", found.charts, {},
                                  [&](const InputError& error) { wrong.emplace_back(error.what()); });
  ASSERT_EQ(colors.size(), 1U);
  EXPECT_EQ(colors[0].file, "chart_key.exr");
  for (int c = 0; c < 3; ++c) EXPECT_NEAR((*colors[0].color.color)[c], made.light[c], .01F);
  EXPECT_THAT(wrong, testing::ElementsAre(testing::HasSubstr("chart_wall.exr")));
}

}  // namespace
}  // namespace swaplight
