#include "core/session/document.h"

#include <algorithm>

#include "core/base/json.h"

namespace swaplight {

namespace {

size_t cameraLookBytes(const FilterPipeline& look) {
  size_t bytes = 0;
  for (const FilterStage& stage : look.stages)
    bytes += sizeof(FilterStage) + stage.filter.size() +
             stage.parameters.size() * sizeof(std::pair<std::string, FilterValue>);
  return bytes;
}

size_t rigBytes(const Rig& rig) {
  size_t bytes = 0;
  for (const LightSetting& light : rig.lights)
    bytes += sizeof(LightSetting) + light.light.size() + light.color.gel.size() + light.label.size();
  return bytes;
}

}  // namespace

size_t documentBytes(const Document& document, const Document& before) {
  size_t bytes = sizeof(Document) + document.source.native().size() + document.colorConfig.native().size() +
                 document.workingSpace.size() + rigBytes(document.rig);
  bytes += editBytes(document.edits, before.edits);
  bytes += cameraLookBytes(document.cameraLook) + document.cues.size() * sizeof(Cue);
  for (size_t i = 0; i < document.looks.size(); ++i) {
    const SavedLook& look = document.looks[i];
    bytes += sizeof(SavedLook) + look.name.size() + look.note.size() + rigBytes(look.rig);
    if (!look.scene) continue;
    // A version's edits are those that were there when it was kept.
    const bool known = i < before.looks.size() && before.looks[i].scene;
    bytes += editBytes(look.scene->edits, known ? before.looks[i].scene->edits : document.edits) +
             cameraLookBytes(look.scene->cameraLook);
  }
  return bytes;
}

Rig fitRig(const Rig& rig, const Capture& capture) {
  Rig fitted = defaultRig(capture);
  fitted.ambient = rig.ambient;
  fitted.groups = rig.groups;
  for (LightSetting& setting : fitted.lights) {
    const auto known = std::find_if(rig.lights.begin(), rig.lights.end(),
                                    [&](const LightSetting& other) { return other.light == setting.light; });
    if (known != rig.lights.end()) setting = *known;
  }
  return fitted;
}

Capture withNewLights(Capture capture, const EditStack& edits) {
  for (const std::string& name : edits.newLights)
    capture.lights.push_back({name, Role::Other, Json::object()});
  return capture;
}

}  // namespace swaplight
