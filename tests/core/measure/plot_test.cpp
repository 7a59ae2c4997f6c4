#include "core/plot/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "core/plot/plot_axis.h"

namespace swaplight {
namespace {

// Pixels of about this colour.
int countColor(const Image& image, const std::array<float, 3>& rgb) {
  int count = 0;
  for (size_t p = 0; p < image.pixelCount(); ++p) {
    bool same = true;
    for (int c = 0; c < 3; ++c) same = same && std::abs(image.plane(c)[p] * 255 - rgb[c]) < 3;
    count += same;
  }
  return count;
}

TEST(PlotAxis, TicksAreRoundNumbersWithinTheLimits) {
  const AxisScale scale = scaleAxis({"x", false, {}, {}}, {0.0, 9.7});
  EXPECT_EQ(scale.low, 0);
  EXPECT_THAT(scale.ticks, testing::ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_DOUBLE_EQ(scale.fraction(scale.low), 0);
  EXPECT_DOUBLE_EQ(scale.fraction(scale.high), 1);
}

TEST(PlotAxis, LogarithmicTicksAreDecadesAndIgnoreWhatCannotBeDrawn) {
  const AxisScale scale = scaleAxis({"x", true, 1e-3, 1e3}, {-1, 0, NAN});
  EXPECT_EQ(scale.ticks.size(), 7u);
  EXPECT_NEAR(scale.fraction(1), .5, 1e-12);
}

TEST(PlotAxis, OfOneValueOrNoneHasARange) {
  for (const std::vector<double>& values : {std::vector<double>{}, {3}, {0}, {-2}, {NAN}}) {
    const AxisScale scale = scaleAxis({"x", false, {}, {}}, values);
    EXPECT_LT(scale.low, scale.high);
    EXPECT_FALSE(scale.ticks.empty());
  }
}

TEST(ScatterPlot, DrawsEachSeriesInItsColour) {
  ScatterPlot plot{"Speed against error", {"megapixels a second", true, {}, {}}, {"error", true, {}, {}}, {}};
  plot.series = {
      {"fast", {10, 100, 1000}, {.1, .05, .03}, ScatterPlot::Style::LineAndPoints, {"a", "b", "c"}},
      {"slow", {1, 2, -5, NAN}, {.02, .01, .01, .01}}};
  const Image image = drawScatterPlot(plot, {640, 480});
  EXPECT_EQ(image.width(), 640);
  EXPECT_GT(countColor(image, {0, 114, 178}), 150);
  // Two of the four points can be drawn, and one stands in the legend.
  const int dots = countColor(image, {213, 94, 0});
  EXPECT_GT(dots, 3 * 35);
  EXPECT_LT(dots, 3 * 75);
  plot.series[0].y.pop_back();
  EXPECT_THROW((void)drawScatterPlot(plot), std::invalid_argument);
}

TEST(BoxPlot, DrawsTheBoxBetweenTheQuartiles) {
  Statistics s;
  s.count = 100;
  s.whiskerLow = 0, s.q1 = 2, s.median = 4, s.mean = 4, s.q3 = 6, s.p95 = 9, s.whiskerHigh = 10;
  BoxPlot plot;
  plot.value = {"value", false, 0., 10.};
  plot.boxes.push_back({"one", s});
  const Image image = drawBoxPlot(plot, {400, 500});
  // Rows whose colour left of the mean is the box's: 2 to 6 of 10 units, but the median's line.
  int first = -1;
  int last = -1;
  for (int y = 0; y < image.height(); ++y) {
    const float blue = image.view().at(2, 200, y);
    const float red = image.view().at(0, 200, y);
    if (blue - red < .2f || blue - red > .5f) continue;
    if (first < 0) first = y;
    last = y;
  }
  ASSERT_GE(first, 0);
  // The axis takes the height minus 14 above and 6.5 lines of 18 below.
  EXPECT_NEAR(last - first, .4 * (500 - 14 - 117), 4);
}

}  // namespace
}  // namespace swaplight
