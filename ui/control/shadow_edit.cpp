#include "ui/control/shadow_edit.h"

#include <algorithm>
#include <cmath>

#include "core/edit/mask/selection.h"
#include "ui/control/light_edit.h"

namespace swaplight {
namespace {

/// Where the page's edits of a light act: on the chosen shadow, or everywhere.
Mask chosenMask(const EditingContext& studio, const std::string& light) {
  const ShadowState& state = studio.editing.shadow;
  Mask mask;
  if (state.chosen && state.light == light)
    mask = {{ShadowShape{light, true, state.chosen->x, state.chosen->y}, false}};
  return maskWithin(mask, studio.document().selection);
}

}  // namespace

bool shadowsShown(const EditingContext& studio) {
  const bool ownPanel = studio.tool && studio.tool->edits;
  return studio.layout.shadows && studio.layout.edits && !studio.layout.hidden && !ownPanel &&
         studio.hasLights();
}

int shadowLight(const ChosenLights& lights, const OpenSet& set) {
  const std::string& name = lights.document().rig.lights[shownLight(lights)].light;
  return set.original->capture.lightIndex(name);
}

std::string shownShadowLight(const EditingContext& studio) {
  const int index = shadowLight(studio, *studio.set());
  return index < 0 ? std::string() : studio.set()->original->capture.lights[static_cast<size_t>(index)].name;
}

std::optional<float> shadowThresholdOf(const Document& document, const std::string& light) {
  const auto given = document.edits.shadowThresholds.find(light);
  return given == document.edits.shadowThresholds.end() ? std::nullopt : std::optional(given->second);
}

void previewShadowThreshold(const EditingContext& studio, const std::string& light, float threshold) {
  Document next = studio.document();
  next.edits.shadowThresholds[light] = threshold;
  studio.editor.preview("Where shadows of " + light + " begin", std::move(next));
}

void resetShadowThreshold(const EditingContext& studio, const std::string& light) {
  Document next = studio.document();
  next.edits.shadowThresholds.erase(light);
  studio.editor.edit("Shadows of " + light + ": automatic threshold", std::move(next));
}

const ShadowMarks& shadowMarksOf(const Document& document, const std::string& light) {
  static const ShadowMarks none;
  const auto made = document.edits.shadowMarks.find(light);
  return made == document.edits.shadowMarks.end() ? none : made->second;
}

void markShadow(const EditingContext& studio, const std::string& light, const ShadowMark& mark, float reach) {
  Document next = studio.document();
  ShadowMarks& marks = next.edits.shadowMarks[light];
  const auto near = [&](const ShadowMark& other) {
    return std::hypot(static_cast<float>(other.x - mark.x), static_cast<float>(other.y - mark.y)) <= reach;
  };
  const auto there = std::find_if(marks.begin(), marks.end(), near);
  const bool again = there != marks.end() && there->is == mark.is;
  if (there != marks.end()) marks.erase(there);
  if (!again) marks.push_back(mark);
  if (marks.empty()) next.edits.shadowMarks.erase(light);
  const char* said = mark.is == ShadowMark::Kind::Lit ? ": this is lit" : ": this is shadow";
  studio.editor.edit("Shadows of " + light + (again ? ": label removed" : said), std::move(next));
}

void clearShadowMarks(const EditingContext& studio, const std::string& light) {
  Document next = studio.document();
  if (next.edits.shadowMarks.erase(light) == 0) return;
  studio.editor.edit("Shadows of " + light + ": labels cleared", std::move(next));
}

int shadowEdit(const EditingContext& studio, const std::string& light, const ShadowKinds& kinds) {
  const Mask mask = chosenMask(studio, light);
  const auto& edits = studio.document().edits.edits;
  const auto isIt = [&](const std::shared_ptr<const Edit>& edit) {
    const auto* shadow = std::get_if<ShadowOperation>(&edit->operation);
    return shadow && edit->on && std::find(kinds.begin(), kinds.end(), shadow->kind) != kinds.end() &&
           edit->lights == std::vector{light} && edit->mask == mask;
  };
  const auto found = std::find_if(edits.begin(), edits.end(), isIt);
  return found == edits.end() ? -1 : static_cast<int>(found - edits.begin());
}

ShadowOperation shadowOperation(const EditingContext& studio, const std::string& light,
                                const ShadowKinds& kinds) {
  const int place = shadowEdit(studio, light, kinds);
  if (place >= 0)
    return std::get<ShadowOperation>(studio.document().edits.edits[static_cast<size_t>(place)]->operation);
  ShadowOperation none;
  none.kind = *kinds.begin();
  none.amount = 0;
  return none;
}

Document withShadowOperation(const EditingContext& studio, const std::string& light, const ShadowKinds& kinds,
                             const ShadowOperation& operation) {
  Document next = studio.document();
  const int place = shadowEdit(studio, light, kinds);
  if (place >= 0) {
    Edit edit = *next.edits.edits[static_cast<size_t>(place)];
    edit.operation = operation;
    if (operation.amount > 0)
      next.edits.replace(static_cast<size_t>(place), std::move(edit));
    else
      next.edits.edits.erase(next.edits.edits.begin() + place);
  } else if (operation.amount > 0) {
    Edit edit;
    edit.mask = chosenMask(studio, light);
    const bool one = studio.editing.shadow.chosen && studio.editing.shadow.light == light;
    edit.name = (one ? "A shadow of " : "Shadows of ") + light;
    edit.lights = {light};
    edit.energy = EnergyMode::Add;
    edit.operation = operation;
    next.edits.append(std::move(edit));
  }
  return next;
}

}  // namespace swaplight
