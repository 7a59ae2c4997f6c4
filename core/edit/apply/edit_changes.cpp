#include "core/edit/apply/edit_changes.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <variant>

namespace swaplight {
namespace {

using Prepared = std::shared_ptr<const PreparedEdit>;

std::vector<PixelRect> activeAreas(const PreparedEdit& edit) {
  return edit.isActive() ? edit.mask->areas() : std::vector<PixelRect>();
}

void append(std::vector<PixelRect>& areas, const std::vector<PixelRect>& more, int around) {
  for (const PixelRect& area : more) areas.push_back(area.grown(around));
}

// Where two edits differ, if it is only by what is painted in their masks.
std::optional<std::vector<PixelRect>> paintedDifference(const PreparedEdit& a, const PreparedEdit& b) {
  if (!a.isActive() || !b.isActive()) return std::nullopt;
  const Mask& maskA = a.edit->mask;
  const Mask& maskB = b.edit->mask;
  if (maskA.size() != maskB.size() || a.edit->opacity != b.edit->opacity ||
      a.edit->lights != b.edit->lights || a.edit->energy != b.edit->energy ||
      !(a.edit->operation == b.edit->operation) || a.beta != b.beta)
    return std::nullopt;
  std::vector<PixelRect> areas;
  for (size_t i = 0; i < maskA.size(); ++i) {
    const auto* paintA = std::get_if<PaintShape>(&maskA[i].shape);
    const auto* paintB = std::get_if<PaintShape>(&maskB[i].shape);
    if (paintA && paintB && maskA[i].invert == maskB[i].invert)
      append(areas, a.mask->raster(i)->differences(*b.mask->raster(i)), 0);
    else if (!(maskA[i] == maskB[i]))
      return std::nullopt;
  }
  return areas;
}

int reachAfter(const std::vector<Prepared>& edits, size_t index) {
  int reach = 0;
  for (size_t i = index + 1; i < edits.size(); ++i) reach += edits[i]->reach();
  return reach;
}

// What is left of two stacks without what they have in common at either end.
struct Middle {
  size_t first = 0, endBefore = 0, endAfter = 0;
  [[nodiscard]] bool isOneEdit() const { return endBefore == first + 1 && endAfter == first + 1; }
};

Middle differingPart(const std::vector<Prepared>& before, const std::vector<Prepared>& after) {
  Middle m{0, before.size(), after.size()};
  while (m.first < before.size() && m.first < after.size() && before[m.first] == after[m.first]) ++m.first;
  while (m.endBefore > m.first && m.endAfter > m.first && before[m.endBefore - 1] == after[m.endAfter - 1])
    --m.endBefore, --m.endAfter;
  return m;
}

// Lights that get light from each other in an edit.
LightIndices tiedBy(const PreparedEdit& edit, int count) {
  if (!edit.isActive()) return {};
  const Operation& operation = edit.edit->operation;
  if (swapsTwoLights(operation) && edit.lights.size() == 2) return {edit.lights.begin(), edit.lights.end()};
  const bool shares = actsOnBeta(operation) && edit.edit->energy == EnergyMode::Redistribute;
  return shares || mixesLights(operation) ? allLights(count) : LightIndices();
}

}  // namespace

LightIndices allLights(int count) {
  std::vector<int> all(static_cast<size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return {all.begin(), all.end()};
}

LightIndices changedLights(const std::vector<Prepared>& before, const std::vector<Prepared>& after,
                           int count) {
  const Middle m = differingPart(before, after);
  LightIndices changed;
  const auto add = [&](const std::vector<Prepared>& edits, size_t end) {
    for (size_t i = m.first; i < end; ++i) {
      if (!edits[i]->isActive()) continue;
      changed.insert(edits[i]->lights.begin(), edits[i]->lights.end());
      changed.merge(tiedBy(*edits[i], count));
    }
  };
  add(before, m.endBefore);
  add(after, m.endAfter);
  return withTiedLights(std::move(changed), after, count);
}

LightIndices withTiedLights(LightIndices lights, const std::vector<Prepared>& edits, int count) {
  for (size_t before = 0; before != lights.size();) {
    before = lights.size();
    for (const Prepared& edit : edits) {
      LightIndices tied = tiedBy(*edit, count);
      const bool reached =
          std::any_of(tied.begin(), tied.end(), [&](int light) { return lights.contains(light); });
      if (reached) lights.merge(tied);
    }
  }
  return lights;
}

size_t commonEdits(const std::vector<Prepared>& before, const std::vector<Prepared>& after) {
  return differingPart(before, after).first;
}

std::vector<PixelRect> changedAreas(const std::vector<Prepared>& before, const std::vector<Prepared>& after) {
  const Middle m = differingPart(before, after);
  std::vector<PixelRect> areas;
  if (m.isOneEdit())
    if (const auto painted = paintedDifference(*before[m.first], *after[m.first])) {
      append(areas, *painted, reachAfter(after, m.first));
      return areas;
    }
  const auto add = [&](const std::vector<Prepared>& edits, size_t end) {
    for (size_t i = m.first; i < end; ++i) append(areas, activeAreas(*edits[i]), reachAfter(edits, i));
  };
  add(before, m.endBefore);
  add(after, m.endAfter);
  return areas;
}

}  // namespace swaplight
