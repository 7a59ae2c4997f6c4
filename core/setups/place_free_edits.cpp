#include "core/setups/place_free_edits.h"

#include <algorithm>

namespace swaplight {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool hasNoPlace(const MaskShape& mask, const std::vector<std::string>& lights);

/// Whether a shape says where it is by the light alone.
template <typename Shape>
bool isPlaceFree(const Shape& shape, const std::vector<std::string>& lights) {
  if constexpr (std::is_same_v<Shape, ShadowShape>) {
    return !shape.region && contains(lights, shape.light);
  } else if constexpr (std::is_same_v<Shape, KeyShape>) {
    return std::all_of(shape.lights.begin(), shape.lights.end(),
                       [&](const auto& light) { return contains(lights, light.first); });
  } else if constexpr (std::is_same_v<Shape, SelectionShape>) {
    return std::all_of(shape.parts->begin(), shape.parts->end(),
                       [&](const SelectionPart& part) { return hasNoPlace(part.shape, lights); });
  } else {
    return false;
  }
}

bool hasNoPlace(const MaskShape& mask, const std::vector<std::string>& lights) {
  return std::visit([&](const auto& shape) { return isPlaceFree(shape, lights); }, mask.shape);
}

template <typename Operation>
constexpr bool kOfItsPicture =
    std::is_same_v<Operation, BetaMapOperation> || std::is_same_v<Operation, UnknownGelOperation> ||
    std::is_same_v<Operation, MoveOperation> || std::is_same_v<Operation, TurnOperation> ||
    std::is_same_v<Operation, SpreadOperation> || std::is_same_v<Operation, PlaceOperation>;

bool holdsElsewhere(const Edit& edit, const std::vector<std::string>& lights) {
  const bool bound = std::visit([]<typename T>(const T&) { return kOfItsPicture<T>; }, edit.operation);
  return !bound &&
         std::all_of(edit.mask.begin(), edit.mask.end(),
                     [&](const MaskShape& mask) { return hasNoPlace(mask, lights); }) &&
         (edit.lights.empty() ||
          std::any_of(edit.lights.begin(), edit.lights.end(),
                      [&](const std::string& light) { return contains(lights, light); }));
}

}  // namespace

PlaceFreeEdits placeFreeEdits(const EditStack& stack, const std::vector<std::string>& lights) {
  // A light that was painted there is another one than the lamp that has its name here.
  std::vector<std::string> known, added;
  for (const std::string& light : lights)
    if (!contains(stack.newLights, light)) known.push_back(light);
  for (const std::string& light : stack.newLights)
    if (!contains(lights, light)) added.push_back(light);
  known.insert(known.end(), added.begin(), added.end());

  PlaceFreeEdits result;
  for (const auto& kept : stack.edits) {
    if (!holdsElsewhere(*kept, known)) {
      if (kept->on) result.leftOut.push_back(kept->name);
      continue;
    }
    Edit edit = *kept;
    std::erase_if(edit.lights, [&](const std::string& light) { return !contains(known, light); });
    for (const std::string& light : added)
      if (contains(edit.lights, light) && !contains(result.edits.newLights, light))
        result.edits.newLights.push_back(light);
    if (edit == *kept)
      result.edits.edits.push_back(kept);
    else
      result.edits.append(std::move(edit));
  }
  if (!stack.lampPlaces.empty()) result.leftOut.emplace_back("where its lamps stood");
  if (!stack.shadowMarks.empty()) result.leftOut.emplace_back("what is said of single shadows");
  for (const auto& [light, threshold] : stack.shadowThresholds)
    if (contains(known, light)) result.edits.shadowThresholds[light] = threshold;
  return result;
}

}  // namespace swaplight
