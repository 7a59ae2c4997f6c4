#include "core/edit/mask/selection.h"

#include <algorithm>

namespace swaplight {
namespace {

bool isSelection(const MaskShape& shape) {
  return std::holds_alternative<SelectionShape>(shape.shape);
}

Mask selectionFrom(std::vector<SelectionPart> parts, float feather) {
  SelectionShape shape;
  shape.parts = std::make_shared<const std::vector<SelectionPart>>(std::move(parts));
  shape.feather = feather;
  return {{std::move(shape), false}};
}

}  // namespace

bool SelectionShape::operator==(const SelectionShape& other) const {
  return feather == other.feather && (parts == other.parts || *parts == *other.parts);
}

Mask selectionWith(const Mask& selection, MaskShape part, SelectHow how) {
  using Combine = SelectionPart::Combine;
  const float feather = featherOf(selection);
  if (selection.empty() && how == SelectHow::Subtract) return {};
  if (selection.empty() || how == SelectHow::Replace)
    return selectionFrom({{std::move(part), Combine::Add}}, feather);
  std::vector<SelectionPart> parts;
  if (selection.front().invert)
    parts.push_back({featheredSelection(selection, 0).front(), Combine::Add});
  else
    parts = *std::get<SelectionShape>(selection.front().shape).parts;
  const Combine combine = how == SelectHow::Add        ? Combine::Add
                          : how == SelectHow::Subtract ? Combine::Subtract
                                                       : Combine::Intersect;
  parts.push_back({std::move(part), combine});
  return selectionFrom(std::move(parts), feather);
}

Mask invertedSelection(const Mask& selection) {
  Mask inverted = selection;
  if (!inverted.empty()) inverted.front().invert = !inverted.front().invert;
  return inverted;
}

Mask featheredSelection(const Mask& selection, float feather) {
  Mask soft = selection;
  if (!soft.empty()) std::get<SelectionShape>(soft.front().shape).feather = feather;
  return soft;
}

float featherOf(const Mask& selection) {
  return selection.empty() ? 0 : std::get<SelectionShape>(selection.front().shape).feather;
}

Mask selectionOf(const Mask& mask) {
  const auto found = std::find_if(mask.begin(), mask.end(), isSelection);
  return found == mask.end() ? Mask() : Mask{*found};
}

Mask maskWithin(const Mask& mask, const Mask& selection) {
  Mask within = mask;
  std::erase_if(within, isSelection);
  within.insert(within.end(), selection.begin(), selection.end());
  return within;
}

}  // namespace swaplight
