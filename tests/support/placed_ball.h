#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/normals/surface_normals.h"

namespace swaplight::test {

// A matte ball of two paints before a wall, under lamps whose places are known.

constexpr int kBallWidth = 96;
constexpr int kBallHeight = 96;
constexpr double kBallRadius = 0.45;  // widths of the picture

inline double columnPlace(int x) {
  return (x + .5) / kBallWidth - .5;
}
inline double rowPlace(int y) {
  return (.5 * kBallHeight - y - .5) / kBallWidth;
}

/// Of a ball before a wall; it goes as deep as the wall in its middle.
inline cv::Vec3d ballNormal(int x, int y) {
  const double px = columnPlace(x);
  const double py = rowPlace(y);
  const double square = kBallRadius * kBallRadius - px * px - py * py;
  if (square <= 0) return {0, 0, 1};
  return cv::Vec3d(px, py, std::sqrt(square)) / kBallRadius;
}

/// What a lamp gives a pixel: falloff times cosine, at least 0.
inline double ballShade(const LampPlace& place, int x, int y) {
  const LampRay ray = LampRays(place).at(columnPlace(x), rowPlace(y));
  return ray.level * std::max(ballNormal(x, y).dot(ray.direction), 0.);
}

inline double ballPaint(int x, int y) {
  return .3 + .4 * ((x / 7 + y / 5) % 2);
}

/// What a lamp sends to each pixel; the shadows are those of surfaces turned away.
struct LitBall {
  SolvedSet set;
  std::vector<LightShadows> shadows;
  std::vector<PlacedLight> lamps;

  [[nodiscard]] ShadowSource source() const {
    return [this](const std::string& light) {
      const LightShadows& found = shadows[static_cast<size_t>(set.capture.lightIndex(light))];
      return std::shared_ptr<const LightShadows>(std::shared_ptr<void>(), &found);
    };
  }
};

using AddedLight = std::function<double(size_t lamp, int x, int y)>;

/// Lights lamp0, lamp1 ... `levels`: of each lamp. `added`: light that no matte surface gives.
inline LitBall ballUnder(
    const std::vector<LampPlace>& places, const std::vector<double>& levels,
    const AddedLight& added = [](size_t, int, int) { return 0.; }) {
  LitBall lit;
  for (size_t i = 0; i < places.size(); ++i) {
    lit.set.capture.lights.push_back({"lamp" + std::to_string(i), Role::Other, {}});
    Image& light = lit.set.contributions.emplace_back(ImageSpec::rgb(kBallWidth, kBallHeight));
    LightShadows& shadows = lit.shadows.emplace_back();
    shadows.labels.resize(light.pixelCount(), ShadowLabel::Umbra);
    shadows.visibility = Image(ImageSpec{kBallWidth, kBallHeight, {"Y"}, "data"}, 0.F);
    const LampRays rays(places[i]);
    for (int y = 0; y < kBallHeight; ++y)
      for (int x = 0; x < kBallWidth; ++x) {
        const double facing = ballNormal(x, y).dot(rays.at(columnPlace(x), rowPlace(y)).direction);
        const double value = levels[i] * ballPaint(x, y) * ballShade(places[i], x, y) + added(i, x, y);
        for (int c = 0; c < 3; ++c) light.span().at(c, x, y) = static_cast<float>(value);
        if (facing <= .05) continue;
        shadows.labels[static_cast<size_t>(y) * kBallWidth + static_cast<size_t>(x)] = ShadowLabel::Lit;
        shadows.visibility.span().at(0, x, y) = 1;
      }
    lit.lamps.push_back({i, places[i]});
  }
  lit.set.beta = Image(ImageSpec{kBallWidth, kBallHeight, {}, "data"});
  return lit;
}

/// The same with what a meter reads of each.
inline std::vector<LampPlace> metered(std::vector<LampPlace> places, const std::vector<double>& stops) {
  for (size_t i = 0; i < places.size(); ++i) places[i].stops = stops[i];
  return places;
}

}  // namespace swaplight::test
