#include "ui/camera/camera_look_edit.h"
#include "core/filter/filter_names.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace swaplight {
namespace {

using Stages = std::vector<FilterStage>;

/// The document with another list of filters, as one step.
template <typename Change>
void changeStages(DocumentEditor& editor, const std::string& step, const Change& change) {
  Document next = editor.document();
  change(next.cameraLook.stages);
  if (next.cameraLook.name.empty()) next.cameraLook.name = "Camera look";
  if (next.cameraLook.stages.empty()) next.cameraLook = {};
  editor.edit(step, std::move(next));
}

Stages::iterator placeOf(Stages& stages, size_t index) {
  return stages.begin() + static_cast<ptrdiff_t>(std::min(index, stages.size()));
}

constexpr float kNeutralReview = 1;

bool isReview(const FilterStage& stage) {
  return stage.filter == kReviewFilter;
}

std::string nameAt(const DocumentEditor& editor, size_t index) {
  return stageName(editor.document().cameraLook.stages.at(index));
}

}  // namespace

std::string stageName(const FilterStage& stage) {
  return isFilterFile(stage.filter) ? std::filesystem::path(stage.filter).stem().string() : stage.filter;
}

size_t addFilter(DocumentEditor& editor, const std::string& filter, std::optional<size_t> at) {
  const size_t count = editor.document().cameraLook.stages.size();
  const size_t index = std::min(at.value_or(count), count);
  changeStages(editor, "Add filter: " + stageName({filter, true, {}, {}}), [&](Stages& stages) {
    stages.insert(placeOf(stages, index), FilterStage{filter, true, {}, {}});
  });
  return index;
}

void removeFilter(DocumentEditor& editor, size_t index) {
  changeStages(editor, "Remove filter: " + nameAt(editor, index),
               [&](Stages& stages) { stages.erase(placeOf(stages, index)); });
}

void duplicateFilter(DocumentEditor& editor, size_t index) {
  changeStages(editor, "Duplicate filter: " + nameAt(editor, index), [&](Stages& stages) {
    const FilterStage copy = stages.at(index);
    stages.insert(placeOf(stages, index + 1), copy);
  });
}

void moveFilter(DocumentEditor& editor, size_t from, size_t to) {
  if (from == to) return;
  changeStages(editor, "Move filter: " + nameAt(editor, from), [&](Stages& stages) {
    const FilterStage moved = std::move(stages.at(from));
    stages.erase(placeOf(stages, from));
    stages.insert(placeOf(stages, to), moved);
  });
}

void switchFilter(DocumentEditor& editor, size_t index, bool on) {
  changeStages(editor, nameAt(editor, index) + (on ? ": on" : ": off"),
               [&](Stages& stages) { stages.at(index).on = on; });
}

void setFilterParameter(DocumentEditor& editor, size_t index, const FilterInput& input,
                        const FilterValue& value, bool live) {
  Document next = editor.document();
  FilterStage& stage = next.cameraLook.stages.at(index);
  if (value == input.standard)
    stage.parameters.erase(input.name);
  else
    stage.parameters[input.name] = value;
  const std::string step = stageName(stage) + ": " + (input.label.empty() ? input.name : input.label);
  if (live)
    editor.preview(step, std::move(next));
  else
    editor.edit(step, std::move(next));
}

float reviewValue(const Document& document, const std::string& name) {
  const Stages& stages = document.cameraLook.stages;
  const auto review = std::find_if(stages.rbegin(), stages.rend(), isReview);
  if (review == stages.rend()) return kNeutralReview;
  const auto value = review->parameters.find(name);
  const auto* number = value == review->parameters.end() ? nullptr : std::get_if<float>(&value->second);
  return number ? *number : kNeutralReview;
}

void setReview(DocumentEditor& editor, const std::string& name, float value, bool live) {
  Document next = editor.document();
  Stages& stages = next.cameraLook.stages;
  auto review = std::find_if(stages.rbegin(), stages.rend(), isReview);
  if (review == stages.rend()) {
    stages.push_back({kReviewFilter, true, {}, {}});
    review = stages.rbegin();
  }
  if (next.cameraLook.name.empty()) next.cameraLook.name = "Camera look";
  review->on = true;
  if (value == kNeutralReview)
    review->parameters.erase(name);
  else
    review->parameters[name] = value;
  if (live)
    editor.preview("Review: " + name, std::move(next));
  else
    editor.edit("Review: " + name, std::move(next));
}

void useCameraLook(DocumentEditor& editor, FilterPipeline look) {
  Document next = editor.document();
  const std::string step = "Camera look: " + look.name;
  next.cameraLook = std::move(look);
  editor.edit(step, std::move(next));
}

void removeCameraLook(DocumentEditor& editor) {
  Document next = editor.document();
  next.cameraLook = {};
  editor.edit("No camera look", std::move(next));
}

}  // namespace swaplight
