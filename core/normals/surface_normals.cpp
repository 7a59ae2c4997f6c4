#include "core/normals/surface_normals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <optional>

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/color/rgb.h"
#include "core/normals/lamp_refinement.h"
#include "core/normals/normal_fit.h"
#include "core/set/measured_pixels.h"

namespace swaplight {
namespace {

constexpr int kRows = 16;
// The part of a light's lit pixels that is below its level: some surface faces the lamp; the rest are
// highlights.
constexpr double kBright = 0.98;
constexpr int kRounds = 6;
constexpr double kMostResidual = 0.15;  // of the reflectance
constexpr double kShadowed = 0.5;       // of what a surface shows of a lamp that it sees: half a penumbra
constexpr int kRefinedPixels = 2500;    // that the lamps' places are refined by: a second, at most
// Standard errors, stops: of a meter, and of the level of a light's bright pixels.
constexpr double kMeteredError = 0.15;
constexpr double kBrightError = 0.5;

/// A lamp, and what makes its light comparable with the others'.
struct Lamp {
  size_t light;
  LampPlace place;
  const Image* picture;
  std::shared_ptr<const LightShadows> shadows;
  LampRays rays;
  double level = 1;

  [[nodiscard]] bool lights(size_t pixel) const { return shadows->labels[pixel] == ShadowLabel::Lit; }
  [[nodiscard]] double grey(size_t pixel) const {
    return (picture->plane(0)[pixel] + picture->plane(1)[pixel] + picture->plane(2)[pixel]) / 3.;
  }
};

/// Where pixels lie, widths of the picture from its middle.
struct Grid {
  int width, height;
  [[nodiscard]] double x(int column) const { return (column + .5) / width - .5; }
  [[nodiscard]] double y(int row) const { return (.5 * height - row - .5) / width; }
};

size_t pixelAt(const Grid& grid, int x, int y) {
  return static_cast<size_t>(y) * static_cast<size_t>(grid.width) + static_cast<size_t>(x);
}

double brightLevel(const Lamp& lamp, const Grid& grid) {
  std::vector<float> levels;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      const size_t pixel = pixelAt(grid, x, y);
      if (lamp.lights(pixel))
        levels.push_back(static_cast<float>(lamp.grey(pixel) / lamp.rays.at(grid.x(x), grid.y(y)).level));
    }
  return levels.empty() ? 0 : quantile(std::span<float>(levels), kBright);
}

/// Pixels here and there.
std::vector<PixelSights> somePixels(const SolvedSet& set, const std::vector<Lamp>& lamps, const Grid& grid) {
  const double pixels = static_cast<double>(grid.width) * grid.height;
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kRefinedPixels))));
  std::vector<PixelSights> found;
  for (int y = step / 2; y < grid.height; y += step)
    for (int x = step / 2; x < grid.width; x += step) {
      if (!isMeasured(set, x, y)) continue;
      PixelSights& sights = found.emplace_back(PixelSights{grid.x(x), grid.y(y), {}, {}});
      for (size_t i = 0; i < lamps.size(); ++i)
        if (lamps[i].lights(pixelAt(grid, x, y))) {
          sights.lamps.push_back(i);
          sights.light.push_back(lamps[i].grey(pixelAt(grid, x, y)));
        }
    }
  return found;
}

/// Those that light anything, refined.
std::vector<Lamp> lampsOf(const SolvedSet& set, const ShadowSource& shadows,
                          const std::vector<PlacedLight>& placed, const Grid& grid) {
  const bool metered = std::all_of(placed.begin(), placed.end(),
                                   [](const PlacedLight& light) { return light.place.stops.has_value(); });
  std::vector<Lamp> lamps;
  std::vector<TunedLamp> told;
  for (const PlacedLight& light : placed) {
    Lamp lamp{light.light, light.place, &set.contributions[light.light],
              shadows(set.capture.lights[light.light].name), LampRays(light.place)};
    lamp.level = metered ? std::exp2(*light.place.stops) : brightLevel(lamp, grid);
    if (lamp.level <= 0) continue;
    lamps.push_back(lamp);
    told.push_back({light.place, lamp.level});
  }
  const auto refined =
      refinedLamps(told, somePixels(set, lamps, grid), metered ? kMeteredError : kBrightError);
  for (size_t i = 0; i < lamps.size(); ++i) {
    lamps[i].place = refined[i].place;
    lamps[i].rays = LampRays(refined[i].place);
    lamps[i].level = refined[i].level;
  }
  return lamps;
}

/// Of some rows.
struct Tally {
  RefusedPixels refused;
  size_t checked = 0;
  size_t shadowed = 0;
};

/// Whether what a lamp gives is so much less than the surface would show of it that it is in shadow.
bool isShadowed(const LampSight& sight, const NormalFit& fit) {
  return sight.light < kShadowed * std::max(sight.direction.dot(fit.scaled), 0.);
}

/// A shadow that was not found only darkens: where the lamps contradict each other, those that give least are
/// left out one by one, as long as they turn out to be in shadow. `sights`: the brightest first.
NormalFit agreedFit(std::span<const LampSight> sights, bool& leftOut) {
  const NormalFit all = fitNormal(sights, kRounds);
  if (all.residual <= kMostResidual) return all;
  for (size_t count = sights.size() - 1; count >= kFewestLamps; --count) {
    const NormalFit fit = fitNormal(sights.first(count), kRounds);
    if (!fit.known() || fit.residual > kMostResidual) continue;
    const auto left = sights.subspan(count);
    if (!std::ranges::all_of(left, [&](const LampSight& sight) { return isShadowed(sight, fit); })) continue;
    leftOut = true;
    return fit;
  }
  return all;
}

std::optional<NormalFit> fitted(std::vector<LampSight>& sights, Tally& tally) {
  if (sights.size() < kFewestLamps) {
    ++tally.refused.fewLamps;
    return std::nullopt;
  }
  std::ranges::sort(sights, std::greater<>(), &LampSight::light);
  bool leftOut = false;
  const NormalFit fit = agreedFit(sights, leftOut);
  if (!fit.known()) {
    ++tally.refused.alike;
  } else if (fit.residual > kMostResidual) {
    ++tally.refused.disagreed;
  } else if (fit.scaled.z() <= 0) {
    ++tally.refused.away;
  } else {
    tally.shadowed += leftOut ? 1 : 0;
    return fit;
  }
  return std::nullopt;
}

void write(const NormalFit& fit, const Rgb& color, size_t pixel, SurfaceNormals& found) {
  const double length = fit.scaled.norm();
  for (int c = 0; c < 3; ++c) {
    found.normals.plane(c)[pixel] = static_cast<float>(fit.scaled[c] / length);
    found.reflectance.plane(c)[pixel] = static_cast<float>(length) * color[c];
  }
}

Tally writeRow(const SolvedSet& set, const std::vector<Lamp>& lamps, const Grid& grid, int y,
               SurfaceNormals& found) {
  Tally tally;
  std::vector<LampSight> sights;
  for (int x = 0; x < grid.width; ++x) {
    const size_t pixel = pixelAt(grid, x, y);
    if (!isMeasured(set, x, y)) {
      ++tally.refused.flagged;
      continue;
    }
    sights.clear();
    Rgb light(0);
    for (const Lamp& lamp : lamps) {
      if (!lamp.lights(pixel)) continue;
      const LampRay ray = lamp.rays.at(grid.x(x), grid.y(y));
      sights.push_back({{ray.direction[0], ray.direction[1], ray.direction[2]},
                        lamp.grey(pixel) / (ray.level * lamp.level)});
      for (int c = 0; c < 3; ++c) light[c] += lamp.picture->plane(c)[pixel];
    }
    const std::optional<NormalFit> fit = fitted(sights, tally);
    if (!fit) continue;
    const float grey = (light[0] + light[1] + light[2]) / 3;
    write(*fit, grey > 0 ? light / grey : Rgb(1), pixel, found);
    tally.checked += sights.size() > kFewestLamps ? 1 : 0;
  }
  return tally;
}

}  // namespace

SurfaceNormals surfaceNormals(const SolvedSet& set, const ShadowSource& shadows,
                              const std::vector<PlacedLight>& lamps, const Progress& progress) {
  progress.update(0, "finding normals");
  const Grid grid{set.width(), set.height()};
  const std::vector<Lamp> known = lampsOf(set, shadows, lamps, grid);
  SurfaceNormals found;
  found.normals =
      Image(ImageSpec{grid.width, grid.height, {"normal.X", "normal.Y", "normal.Z"}, "data"}, 0.F);
  found.reflectance = Image(ImageSpec::rgb(grid.width, grid.height), 0.F);
  for (const Lamp& lamp : known) found.lamps.push_back({lamp.light, lamp.place, lamp.level});
  std::mutex adding;
  parallelRows(grid.height, kRows, [&](int begin, int end) {
    progress.update(0.2F, "finding normals");
    for (int y = begin; y < end; ++y) {
      const Tally tally = writeRow(set, known, grid, y, found);
      const std::lock_guard lock(adding);
      found.refused.flagged += tally.refused.flagged;
      found.refused.fewLamps += tally.refused.fewLamps;
      found.refused.alike += tally.refused.alike;
      found.refused.disagreed += tally.refused.disagreed;
      found.refused.away += tally.refused.away;
      found.checked += tally.checked;
      found.shadowed += tally.shadowed;
    }
  });
  return found;
}

}  // namespace swaplight
