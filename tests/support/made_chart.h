#pragma once

#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "core/chart/chart_corners.h"
#include "core/image/image.h"

namespace swaplight::test {

/// A camera that is no Rec.709 one: its balanced R G B of linear Rec.709 (white stays white).
inline glm::dmat3 cameraFromRec709() {
  return glm::transpose(glm::dmat3(.78, .17, .05, .12, .80, .08, .03, .22, .75));  // rows
}

/// A photograph of a Macbeth chart on a black frame before a speckled wall.
struct MadeChart {
  int width = 900, height = 640;
  ChartCorners corners{{{210, 150}, {660, 110}, {690, 470}, {180, 420}}};
  Rgb light{.8F, .6F, .4F};  ///< in the camera's R G B
  glm::dmat3 camera{1};      ///< balanced camera R G B of linear Rec.709
  double gap = kChartGap;    ///< in patches
  float noise = 0;           ///< standard deviation of a pixel
  float full = 1;            ///< of the sensor: brighter is clipped
  std::function<double(double x, double y)> level = [](double, double) { return 1; };  ///< over the chart
  std::function<Rgb(size_t patch)> spoiled = [](size_t) { return Rgb(1); };

  [[nodiscard]] Rgb reflected(const ChartPlace& at) const {
    constexpr double kFrame = .35;  // patches
    const double chartWidth = kChartColumns + (kChartColumns - 1) * gap;
    const double chartHeight = kChartRows + (kChartRows - 1) * gap;
    const double x = at.x * chartWidth, y = at.y * chartHeight;
    if (x < -kFrame || y < -kFrame || x > chartWidth + kFrame || y > chartHeight + kFrame) {
      const double wall = .3 + .05 * std::sin(60 * at.x) * std::sin(47 * at.y);
      return Rgb(wall, wall * .9, wall * .8);
    }
    const double column = std::floor(x / (1 + gap)), row = std::floor(y / (1 + gap));
    const bool inside = x >= 0 && y >= 0 && column < kChartColumns && row < kChartRows &&
                        x - column * (1 + gap) <= 1 && y - row * (1 + gap) <= 1;
    if (!inside) return Rgb(.02F);
    const auto patch = size_t(row * kChartColumns + column);
    return chartReflectances()[patch] * spoiled(patch);
  }

  [[nodiscard]] Image photograph() const {
    const ChartPerspective perspective(corners);
    Image image({width, height, {"R", "G", "B"}, "lin_rec709"}, 0);
    std::mt19937 random(5);
    std::normal_distribution<float> normal(0, 1);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        glm::dvec3 sum(0);
        for (const double dx : {-.25, .25})
          for (const double dy : {-.25, .25}) {
            const ChartPlace at = perspective.inChart({x + dx, y + dy});
            sum += camera * glm::dvec3(reflected(at)) * level(at.x, at.y) / 4.0;
          }
        for (int c = 0; c < 3; ++c)
          image.plane(c)[size_t(y) * size_t(width) + size_t(x)] =
              std::min(float(sum[c]) * light[c] + noise * normal(random), full);
      }
    return image;
  }
};

}  // namespace swaplight::test
