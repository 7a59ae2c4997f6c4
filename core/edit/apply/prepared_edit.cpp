#include "core/edit/apply/prepared_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/capture/no_such_light.h"

namespace swaplight {
namespace {

std::string calledName(const Edit& edit) {
  return edit.name.empty() ? operationName(edit.operation) : edit.name;
}

std::vector<int> chosenLights(const Edit& edit, const EditedLights& lights) {
  std::vector<int> chosen;
  const int count = static_cast<int>(lights.names.size());
  for (int i = 0; i < count; ++i)
    if (edit.lights.empty() ||
        std::count(edit.lights.begin(), edit.lights.end(), lights.names[static_cast<size_t>(i)]))
      chosen.push_back(i);
  for (const std::string& name : edit.lights)
    static_cast<void>(placeOfLight(lights.names, name, fmt::format("edit \"{}\"", calledName(edit))));
  return chosen;
}

// A key, also one that is part of a selection, names the lights that it was taken under.
void checkKey(const MaskShape& mask, const EditedLights& lights, const std::string& where) {
  if (const auto* key = std::get_if<KeyShape>(&mask.shape))
    for (const auto& [name, factor] : key->lights) static_cast<void>(placeOfLight(lights.names, name, where));
  if (const auto* selection = std::get_if<SelectionShape>(&mask.shape))
    for (const SelectionPart& part : *selection->parts) checkKey(part.shape, lights, where);
}

int zoneOf(const Operation& operation, int width) {
  const auto* shadow = std::get_if<ShadowOperation>(&operation);
  return shadow ? shadowZone(*shadow, width) : 0;
}

// What the operation looks up of each chosen light's shadows, or what was looked up before.
std::vector<ShadowChange> shadowChanges(const ShadowOperation& operation, const Edit& edit,
                                        const std::vector<int>& chosen, const EditedLights& lights,
                                        const MaskContext& context, const PreparedEdit* earlier) {
  const ShadowSource& shadows = context.shadows();
  if (!shadows)
    throw InputError("the edit \"{}\" uses shadows, which are not available here.", calledName(edit));
  const auto* before = earlier ? std::get_if<ShadowOperation>(&earlier->edit->operation) : nullptr;
  const bool all = edit.mask.empty();
  const bool same = before && earlier->lights == chosen && earlier->edit->mask.empty() == all;
  if (same && sameShadowChange(*before, operation)) return earlier->shadows;
  std::vector<ShadowChange> changes;
  for (size_t k = 0; k < chosen.size(); ++k) {
    const auto light = static_cast<size_t>(chosen[k]);
    if (light >= context.set().contributions.size()) {  // one that the edits add throws none
      changes.emplace_back();
      continue;
    }
    changes.push_back(shadowChange(operation, shadows(lights.names[light]), context.set(), light, all,
                                   same ? &earlier->shadows[k] : nullptr));
  }
  return changes;
}

// What the operation looks up of each chosen light's lamp.
std::vector<LampEdit> lampEdits(const LampChange& change, const std::vector<int>& chosen,
                                const MaskContext& context, const PreparedEdit* earlier) {
  const bool same = earlier && earlier->lights == chosen && earlier->lamps.size() == chosen.size();
  std::vector<LampEdit> edits;
  for (size_t k = 0; k < chosen.size(); ++k)
    edits.push_back(
        lampEdit(change, static_cast<size_t>(chosen[k]), context, same ? &earlier->lamps[k] : nullptr));
  return edits;
}

std::vector<PlacedChange> placedChanges(const PlaceOperation& operation, const std::vector<int>& chosen,
                                        const EditedLights& lights, const MaskContext& context) {
  std::vector<PlacedChange> changes;
  for (const int light : chosen)
    changes.emplace_back(operation, lights.names[static_cast<size_t>(light)], static_cast<size_t>(light),
                         context, lights.places);
  return changes;
}

}  // namespace

int PreparedEdit::reach() const {
  return isActive() ? operationReach(edit->operation) : 0;
}

std::optional<BetaRequest> betaRequest(const Edit& edit, const EditedLights& lights) {
  const auto* picture = std::get_if<BetaMapOperation>(&edit.operation);
  if (!picture) return std::nullopt;
  if (picture->file.empty())
    throw InputError("edit \"{}\": \"file\" is missing, expected the path of a beta map", calledName(edit));
  BetaRequest request{*picture, {}, lights.width, lights.height};
  for (const int i : chosenLights(edit, lights))
    request.lights.push_back(lights.names[static_cast<size_t>(i)]);
  return request;
}

void checkBeta(const Edit& edit, const EditedLights& lights, const BetaMaps& beta) {
  const auto& picture = std::get<BetaMapOperation>(edit.operation);
  if (edit.energy == EnergyMode::Redistribute)
    checkProportions(beta, beta.maps.size() == lights.names.size(), picture.file);
}

PreparedEdit prepareEdit(std::shared_ptr<const Edit> edit, const EditedLights& lights, MaskContext& context,
                         BetaFiles& files, const PreparedEdit* earlier) {
  if (actsOnAllLights(edit->operation) && !edit->lights.empty())
    throw InputError("edit \"{}\" ({}) names lights, but acts on all of them: leave out its lights.",
                     calledName(*edit), operationName(edit->operation));
  PreparedEdit prepared;
  prepared.lights = chosenLights(*edit, lights);
  for (const MaskShape& shape : edit->mask)
    checkKey(shape, lights, fmt::format("edit \"{}\": the key of its mask", calledName(*edit)));
  const int zone = zoneOf(edit->operation, lights.width);
  if (earlier && earlier->edit->mask == edit->mask && zoneOf(earlier->edit->operation, lights.width) == zone)
    prepared.mask = earlier->mask;
  else
    prepared.mask = std::make_shared<PreparedMask>(edit->mask, context, zone);
  std::visit(
      [&]<typename T>(const T& operation) {
        if constexpr (std::is_same_v<T, ShadowOperation>)
          prepared.shadows = shadowChanges(operation, *edit, prepared.lights, lights, context, earlier);
        if constexpr (LampOperation<T>)
          prepared.lamps = lampEdits(operation.lampChange(), prepared.lights, context, earlier);
        if constexpr (std::is_same_v<T, PlaceOperation>)
          if (edit->on && edit->opacity > 0)
            prepared.placed = placedChanges(operation, prepared.lights, lights, context);
        if constexpr (std::is_same_v<T, UnknownGelOperation>)
          prepared.gel = gelMixing(context.set(), operation);
        if constexpr (requires { operation.tabulate(); }) prepared.table = operation.tabulate();
      },
      edit->operation);
  if (const auto request = betaRequest(*edit, lights)) {
    prepared.beta = files.maps(*request);
    checkBeta(*edit, lights, *prepared.beta);
  }
  prepared.edit = std::move(edit);
  return prepared;
}

}  // namespace swaplight
