#include "core/view/comparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swaplight {

glm::dvec3 sideOfB(const Comparison& comparison, const ViewWindow& window) {
  const double angle = comparison.angleDegrees * std::numbers::pi / 180;
  const double nx = std::cos(angle), ny = std::sin(angle);
  return {nx, ny, -nx * window.windowX(comparison.x) - ny * window.windowY(comparison.y)};
}

std::pair<int, int> columnsOfB(const glm::dvec3& side, int row, int width) {
  const double constant = side.y * (row + 0.5) + side.z;
  constexpr double kLevel = 1e-9;  // a line along the row
  if (std::abs(side.x) < kLevel) return constant >= 0 ? std::pair{0, width} : std::pair{0, 0};
  const double edge = std::clamp(std::ceil(-constant / side.x - 0.5), 0.0, static_cast<double>(width));
  if (side.x > 0) return {static_cast<int>(edge), width};
  return {0, std::clamp(static_cast<int>(std::floor(-constant / side.x - 0.5)) + 1, 0, width)};
}

std::vector<ViewLayer> differenceLayers(const std::vector<ViewLayer>& a, const std::vector<ViewLayer>& b) {
  std::vector<ViewLayer> layers = a;
  for (const ViewLayer& minus : b) {
    const auto same = std::find_if(layers.begin(), layers.end(),
                                   [&](const ViewLayer& layer) { return layer.picture == minus.picture; });
    if (same != layers.end())
      same->factor -= minus.factor;
    else
      layers.push_back({minus.picture, -minus.factor});
  }
  return layers;
}

}  // namespace swaplight
