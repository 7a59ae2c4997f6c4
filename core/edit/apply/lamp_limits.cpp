#include "core/edit/apply/lamp_limits.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/edit/pool/lamp_gain.h"
#include "core/edit/pool/lamp_handle.h"

namespace swaplight {
namespace {

constexpr int kColumns = 96;  // of the grid: cones have no detail

template <typename Visit>
void visitGrid(const EditedLights& lights, const Visit& visit) {
  const int step = std::max(1, lights.width / kColumns);
  for (int y = step / 2; y < lights.height; y += step)
    for (int x = step / 2; x < lights.width; x += step) visit(x, y);
}

// Whether at least half of what is seen there is the edit's.
bool actsAt(const PreparedEdit& edit, int x, int y) {
  float mask = 0;
  edit.mask->row(x, y, 1, &mask);
  return mask * edit.edit->opacity >= .5F;
}

// Of the picture's area, where at least half of what the edit shows is a guess: isGuess(x, y).
template <typename IsGuess>
double guessedArea(const PreparedEdit& edit, const EditedLights& lights, const IsGuess& isGuess) {
  int guessed = 0;
  int all = 0;
  visitGrid(lights, [&](int x, int y) {
    ++all;
    guessed += isGuess(x, y) && actsAt(edit, x, y);
  });
  return all > 0 ? double(guessed) / all : 0;
}

// Those of them that change the light's lamp in the same way: moves where the edit is one.
std::vector<const PreparedEdit*> alikeBefore(const PreparedEdit& edit, int light, const EarlierEdits& edits) {
  std::vector<const PreparedEdit*> alike;
  for (const auto& other : edits)
    if (other->isActive() && other->edit->operation.index() == edit.edit->operation.index() &&
        std::ranges::count(other->lights, light))
      alike.push_back(other.get());
  return alike;
}

LampChange together(LampChange change, const LampChange& other) {
  change.right += other.right;
  change.up += other.up;
  change.pan += other.pan;
  change.tilt += other.tilt;
  return change;
}

// How far the edit moves and turns the light's lamp, with what earlier edits of its kind have done: what
// comes together at places where it acts. One that is nowhere strong counts by itself.
std::vector<LampChange> changesOf(const PreparedEdit& edit, int light, const EditedLights& lights,
                                  const EarlierEdits& earlier) {
  const LampChange own = lampChangeOf(edit.edit->operation);
  const std::vector<const PreparedEdit*> alike = alikeBefore(edit, light, earlier);
  if (own == LampChange() || alike.empty()) return {own};
  std::vector<LampChange> changes;
  visitGrid(lights, [&](int x, int y) {
    if (!actsAt(edit, x, y)) return;
    LampChange sum = own;
    for (const PreparedEdit* other : alike)
      if (actsAt(*other, x, y)) sum = together(sum, lampChangeOf(other->edit->operation));
    if (std::ranges::find(changes, sum) == changes.end()) changes.push_back(sum);
  });
  return changes.empty() ? std::vector{own} : changes;
}

bool inPicture(const PlanePoint& place, const EditedLights& lights) {
  return std::abs(place.x) <= .5 && std::abs(place.y) <= .5 * lights.height / lights.width;
}

// Whether the turn carries the middle of its light out of the picture.
bool turnsOut(const LampModel& lamp, const LampChange& change, const EditedLights& lights) {
  return (change.pan != 0 || change.tilt != 0) && inPicture({lamp.aim[0], lamp.aim[1]}, lights) &&
         !inPicture(middleOf(lamp, change), lights);
}

// Of a cone, what lies in the picture: of its ellipse, where its outline goes on beyond.
double seenOf(const LightCone& cone, const EditedLights& lights) {
  if (cone.outline && !cone.outline->isCut()) return 1;
  constexpr int kSteps = 40;
  const double halfHeight = .5 * lights.height / lights.width;
  int seen = 0;
  int all = 0;
  for (int j = 0; j < kSteps; ++j)
    for (int i = 0; i < kSteps; ++i) {
      const double a = (2. * i + 1) / kSteps - 1;
      const double b = (2. * j + 1) / kSteps - 1;
      if (a * a + b * b > 1) continue;
      const double x = cone.x + cone.cosine * a * cone.radiusA - cone.sine * b * cone.radiusB;
      const double y = cone.y + cone.sine * a * cone.radiusA + cone.cosine * b * cone.radiusB;
      ++all;
      seen += std::abs(x) <= .5 && std::abs(y) <= halfHeight;
    }
  return double(seen) / all;
}

}  // namespace

LampLimits lampLimits(const PreparedEdit& edit, size_t k, const EditedLights& lights,
                      const EarlierEdits& earlier) {
  LampLimits limits;
  if (k >= edit.lamps.size() || !edit.lamps[k].gain || !edit.isActive()) return limits;
  const LightPool& pool = *edit.lamps[k].pool;
  const LampGain& gain = *edit.lamps[k].gain;
  limits.guessed = guessedArea(edit, lights, [&](int x, int y) { return gain.guessAt(x, y) >= .5F; });
  for (const LampChange& change : changesOf(edit, edit.lights[k], lights, earlier)) {
    limits.shift = std::max(limits.shift, std::hypot(change.right, change.up) / pool.width);
    limits.turnsOut = limits.turnsOut || turnsOut(pool.lamp, change, lights);
  }
  if (pool.cone) limits.seen = seenOf(*pool.cone, lights);
  return limits;
}

std::vector<std::string> lampWarnings(const PreparedEdit& edit, const EditedLights& lights,
                                      const EarlierEdits& earlier) {
  std::vector<std::string> warnings;
  const auto placed = std::ranges::find_if_not(edit.placed, &PlacedChange::isNeutral);
  if (placed != edit.placed.end() && edit.isActive()) {
    const PlacedChange& change = *placed;
    const double guessed = guessedArea(edit, lights, [&](int x, int y) { return change.guessAt(x, y); });
    if (guessed >= LampLimits::kGuessTold)
      warnings.push_back(fmt::format(
          "how surfaces are turned is a guess on {:.0f} % of the picture: too few lamps light it, or they "
          "disagree",
          100 * guessed));
  }
  for (size_t k = 0; k < edit.shadows.size(); ++k)
    if (!edit.shadows[k].shadows && edit.isActive() && !edit.edit->lights.empty())
      warnings.push_back(fmt::format("\"{}\" was not photographed and throws no shadows: nothing changes",
                                     lights.names[static_cast<size_t>(edit.lights[k])]));
  for (size_t k = 0; k < edit.lamps.size(); ++k) {
    if (!edit.lamps[k].pool && edit.isActive() && !edit.edit->lights.empty())
      warnings.push_back(
          fmt::format("\"{}\" was not photographed, nothing is known of its lamp: nothing changes. Place it",
                      lights.names[static_cast<size_t>(edit.lights[k])]));
    const LampLimits limits = lampLimits(edit, k, lights, earlier);
    const std::string& light = lights.names[static_cast<size_t>(edit.lights[k])];
    if (limits.guessed >= LampLimits::kGuessTold)
      warnings.push_back(fmt::format("\"{}\" is a guess on {:.0f} % of the picture: its lamp never lit that",
                                     light, 100 * limits.guessed));
    if (edit.lamps[k].size != 1 && edit.isActive() && edit.lamps[k].pool->cone)
      warnings.push_back(fmt::format(
          "\"{}\" is a spot: the size of so small a lamp changes little, and what it changes is a "
          "guess",
          light));
    if (limits.seen < LampLimits::kLeastSeen)
      warnings.push_back(fmt::format(
          "only {:.0f} % of what \"{}\" lights is in the picture: where its lamp stands is a guess",
          100 * limits.seen, light));
    const LampChange own = lampChangeOf(edit.edit->operation);
    const double alone = edit.lamps[k].pool ? std::hypot(own.right, own.up) / edit.lamps[k].pool->width : 0;
    constexpr double kRounding = .005;
    if (limits.shift > LampLimits::kFarthest + kRounding)
      warnings.push_back(
          fmt::format("\"{}\" moves by {:.0f} % of the width that it lights{} while its shadows stay "
                      "where they are: up to {:.0f} % looks right",
                      light, 100 * limits.shift, limits.shift == alone ? "" : ", with the moves before,",
                      100 * LampLimits::kFarthest));
    if (limits.turnsOut)
      warnings.push_back(
          fmt::format("\"{}\" is turned until the middle of its light lies outside the picture: the part of "
                      "its beam that lights it now was never photographed, and is a guess",
                      light));
  }
  return warnings;
}

}  // namespace swaplight
