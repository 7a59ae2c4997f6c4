#include "core/edit/placing/placed_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/normals/placed_lights.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr float kLitWell = 0.15F;  // of the shade: below, the surface was nearly turned away
constexpr float kLeastLight = 1e-9F;
// Of the picture: where less is known it is all a guess (of ten rendered sets the three that were below were
// no better placed, or worse, than left alone).
constexpr double kLeastKnown = 0.4;

SWAPLIGHT_SIMD(void, addShade,
               (const float* paint, const float* after, const float* mask, float level, int count,
                float* light),
               (paint, after, mask, level, count, light)) {
  for (int i = 0; i < count; ++i) light[i] += mask[i] * level * paint[i] * after[i];
}

// What comes is added, as the surface reflects it; what goes is taken off in proportion, so that none is left
// over. What shows as much light as a surface so turned has of the lamp sees it, whatever the search for
// shadows says of dim light; and what was turned away from the lamp is taken to see it once it is turned
// there.
SWAPLIGHT_SIMD(void, reshade,
               (const float* paint, const float* solved, const float* before, const float* after,
                const float* seen, const float* mask, float level, float nearer, int count, float* light),
               (paint, solved, before, after, seen, mask, level, nearer, count, light)) {
  for (int i = 0; i < count; ++i) {
    const float then = nearer * after[i];
    const float left = solved[i] > light[i] ? light[i] / solved[i] : 1.F;
    const float gives = left * level * paint[i];
    const float shown = std::min(light[i] / std::max(gives * before[i], kLeastLight), 1.F);
    const float lit = std::min(before[i] / kLitWell, 1.F);
    const float sees = 1 + lit * lit * (3 - 2 * lit) * (std::max(seen[i], shown) - 1);
    const float more = light[i] + sees * gives * (then - before[i]);
    const float less = light[i] * (1 + sees * (then / std::max(before[i], kLeastLight) - 1));
    const float changed = then < before[i] ? less : more;
    light[i] = std::max(light[i] + mask[i] * (changed - light[i]), 0.F);
  }
}

/// Where the lamp stands, as refined, after what the operation changes of what was told.
LampPlace placeAfter(const PlaceOperation& operation, const LampPlace& told, const LampPlace& refined) {
  LampPlace after = operation.place();
  after.azimuth += refined.azimuth - told.azimuth;
  after.elevation += refined.elevation - told.elevation;
  return after;
}

float nearerBy(const LampPlace& before, const LampPlace& after) {
  if (!before.distance || !after.distance) return 1;
  return static_cast<float>(std::pow(*before.distance / std::max(*after.distance, LampRays::kNearest), 2));
}

}  // namespace

std::optional<std::string> whyNotPlaced(const std::string& light, const LampPlaces& told,
                                        const Capture& capture) {
  try {
    static_cast<void>(placedLights(told, capture, "the lamps' places"));
  } catch (const InputError& error) {
    return error.what();
  }
  if (capture.lightIndex(light) < 0) return std::nullopt;
  const auto place = told.find(light);
  if (place != told.end() && !place->second.isTooNear()) return std::nullopt;
  return fmt::format("\"{}\" cannot be placed: {}. Tell where it stood, or place a new light.", light,
                     place == told.end() ? "nobody has said where its lamp stood"
                                         : fmt::format("its lamp is nearer than {} widths of the picture",
                                                       LampPlace::kNearest));
}

std::optional<std::string> whyNotPlaced(const SetSurfaces& surfaces) {
  const double known = 1 - surfaces.guessedShare;
  if (known >= kLeastKnown) return std::nullopt;
  return fmt::format(
      "how surfaces are turned can be told on {:.0f} % of the picture only: no lamp can be placed. Check "
      "where "
      "the lamps stood, or light the set with more of them.",
      100 * known);
}

PlacedChange::PlacedChange(const PlaceOperation& operation, const std::string& name, size_t light,
                           const MaskContext& context, const LampPlaces& told)
    : m_after(operation.place(), operation.diameter) {
  if (!context.surfaces()) throw InputError("how surfaces are turned is not available here.");
  if (const auto problem = whyNotPlaced(name, told, context.set().capture)) throw InputError(*problem);
  m_surfaces = context.surfaces()();
  if (!m_surfaces) throw InputError("how surfaces are turned has not been found yet.");
  if (const auto problem = whyNotPlaced(*m_surfaces)) throw InputError(*problem);
  m_level = static_cast<float>(m_surfaces->level);
  if (light >= context.set().contributions.size()) return;
  const LeveledLight* lamp = m_surfaces->lampOf(light);
  if (!lamp) {  // it lights nothing
    m_neutral = true;
    return;
  }
  const LampPlace& place = told.at(name);
  m_shadows = context.shadows()(name);
  m_level = static_cast<float>(lamp->level);
  m_before.emplace(lamp->place, 0);
  m_after = PlacedLamp(placeAfter(operation, place, lamp->place), operation.diameter);
  m_nearer = nearerBy(place, operation.place());
  m_neutral = operation == PlaceOperation::at(place);
}

void PlacedChange::changeRow(int x, int y, int count, const float* mask, const PlacedRow& row) const {
  const Image& normals = m_surfaces->normals;
  const auto width = static_cast<float>(normals.width());
  NormalRow surface;
  for (int c = 0; c < 3; ++c) surface.normal[c] = normals.view().row(c, y) + x;
  surface.x = (static_cast<float>(x) + .5F) / width - .5F;
  surface.step = 1 / width;
  surface.y = (.5F * static_cast<float>(normals.height()) - static_cast<float>(y) - .5F) / width;
  std::vector<float> after(static_cast<size_t>(count));
  m_after.shadeRow(surface, count, after.data());
  std::vector<float> before(m_before ? after.size() : 0);
  if (m_before) m_before->shadeRow(surface, count, before.data());
  for (size_t c = 0; c < 3; ++c) {
    if (!m_before)
      addShade(row.paint[c], after.data(), mask, m_level, count, row.light[c]);
    else
      reshade(row.paint[c], row.solved[c], before.data(), after.data(),
              m_shadows->visibility.view().row(0, y) + x, mask, m_level, m_nearer, count, row.light[c]);
  }
}

bool PlacedChange::guessAt(int x, int y) const {
  return m_surfaces->guessed[static_cast<size_t>(y) * static_cast<size_t>(m_surfaces->normals.width()) +
                             static_cast<size_t>(x)] != 0;
}

}  // namespace swaplight
