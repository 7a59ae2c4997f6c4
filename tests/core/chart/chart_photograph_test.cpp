#include "core/chart/chart_photograph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/chart/chart_colors.h"
#include "core/image/io/image_io.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/made_chart.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

class ChartPhotographTest : public testing::Test {
 protected:
  ChartPhotograph photograph(const test::MadeChart& chart, const char* name = "chart.exr") {
    writeImage(chart.photograph(), folder / name);
    return readChartPhotograph(test::builtinColors(), folder / name, "");
  }

  test::TemporaryFolder folder;
  test::MadeChart made;
};

double farthest(const ChartCorners& a, const ChartCorners& b) {
  double most = 0;
  for (size_t j = 0; j < 4; ++j) most = std::max(most, std::hypot(a[j].x - b[j].x, a[j].y - b[j].y));
  return most;
}

TEST_F(ChartPhotographTest, CornersThatAPersonPutsDownAreMovedToTheChart) {
  const ChartPhotograph one = photograph(made);
  const auto found = foundChart(one);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->found);
  // Roughly, and from another corner on: as a hand does it.
  const ChartCorners& c = made.corners;
  const ChartCorners rough{{{c[2].x + 9, c[2].y - 8},
                            {c[3].x - 8, c[3].y + 6},
                            {c[0].x + 7, c[0].y + 9},
                            {c[1].x - 5, c[1].y - 9}}};
  const ChartShot told = chartAt(one, rough);
  EXPECT_FALSE(told.found);
  EXPECT_LT(farthest(told.corners, made.corners), 8);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(told.fit.light[k], found->fit.light[k], .01F);
  EXPECT_THROW((void)chartAt(one, {{{20, 20}, {120, 20}, {120, 80}, {20, 80}}}), InputError) << "the wall";
}

TEST_F(ChartPhotographTest, ADeepGelIsReadWhereTheChartIsWithoutIt) {
  const ChartPhotograph open = photograph(made);
  const auto found = foundChart(open);
  ASSERT_TRUE(found);
  test::MadeChart gelled = made;
  gelled.light = {.02F, .03F, .5F};
  const ChartPhotograph deep = photograph(gelled, "deep.exr");
  const auto read = chartAsIn(deep, *found);
  ASSERT_TRUE(read);
  EXPECT_NEAR(read->fit.light.b, .5F, .02F);
  EXPECT_THAT(read->fit.warnings, testing::Contains(testing::HasSubstr("chart.exr")));
  gelled.width += 10;
  EXPECT_FALSE(chartAsIn(photograph(gelled, "wide.exr"), *found)) << "another size";
}

TEST_F(ChartPhotographTest, ItsLightIsAColourOfTheShotsBesideIt) {
  const auto chart = foundChart(photograph(made, "chart_key.exr"));
  ASSERT_TRUE(chart);
  writeImage(made.photograph(), folder / "shot.exr");
  const ShotFolder shots = scanShotFolder(test::builtinColors(), folder.path());
  const ShotColor color = lightOfChart(test::builtinColors(), shots, "lin_rec709", *chart);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR((*color.color)[k], made.light[k], .01F);
}

}  // namespace
}  // namespace swaplight
