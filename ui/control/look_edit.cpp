#include "ui/control/look_edit.h"

#include <fmt/core.h>

#include "core/base/error.h"
#include "core/look/rig_blend.h"
#include "core/session/version.h"
#include "ui/control/light_edit.h"

namespace swaplight {

const LightRatios& lightRatios(const LightsContext& lights) {
  LookState& state = lights.looks;
  if (state.ratiosOfSet != lights.session.setRevision()) {
    state.ratios = LightRatios(lights.set()->solved());
    state.ratiosOfSet = lights.session.setRevision();
  }
  return state.ratios;
}

namespace {

/// Says which lights a look has changed that have no role in it, as a painted one: nobody expects those.
void sayOthersChanged(const LightsContext& lights, const std::string& look, const Rig& before,
                      const Rig& after) {
  std::string names;
  size_t count = 0;
  for (size_t i = 0; i < before.lights.size(); ++i) {
    if (before.lights[i].role != Role::Other || before.lights[i] == after.lights[i]) continue;
    names += (names.empty() ? "" : ", ") + before.lights[i].title();
    ++count;
  }
  if (count == 0) return;
  lights.messages.info(
      fmt::format("{} has changed {}, too, which {} no role.", look, names, count == 1 ? "has" : "have"));
}

}  // namespace

void applyPreset(const LightsContext& lights, const Look& look) {
  // Another preset instead of one that is being tried: both are over what was before.
  const LookState::Blend* tried = activeBlend(lights);
  const Rig before = tried ? tried->before : lights.document().rig;
  try {
    const Rig whole = applyLook(before, look, lightRatios(lights));
    editRig(lights, look.name, whole);
    sayOthersChanged(lights, look.name, before, whole);
    if (leavesDark(whole))
      lights.messages.info(
          "There is no back light in this set, and " + look.name +
          " leaves the others dark. Give a light the role back below, or paint a new light on "
          "the background (Shift+B).");
    lights.looks.blend = LookState::Blend{look.name, before, whole, whole, 1};
  } catch (const InputError& error) {
    lights.messages.error(error.what());
  }
}

const LookState::Blend* activeBlend(const LightsContext& lights) {
  const std::optional<LookState::Blend>& blend = lights.looks.blend;
  return blend && blend->shown == lights.document().rig ? &*blend : nullptr;
}

void previewBlend(const LightsContext& lights, float amount) {
  LookState::Blend& blend = *lights.looks.blend;
  blend.amount = amount;
  blend.shown = blendRigs(blend.before, blend.whole, amount);
  Document next = lights.document();
  next.rig = blend.shown;
  lights.editor.preview(blend.name + ": amount", std::move(next));
}

namespace {

void keep(const LightsContext& lights, SavedLook look) {
  std::vector<SavedLook> looks = lights.document().looks;
  const std::string step = "Keep " + look.name;
  try {
    addLook(looks, std::move(look));
  } catch (const InputError& error) {
    return lights.messages.warn(error.what());
  }
  editLooks(lights, step, std::move(looks));
}

}  // namespace

void keepLook(const LightsContext& lights) {
  keep(lights, {freeLookName(lights.document().looks), "", lights.document().rig});
}

void keepVersion(const LightsContext& lights) {
  keep(lights, versionOf(lights.document(), freeLookName(lights.document().looks, "Version")));
}

void recallLook(const LightsContext& lights, const SavedLook& look) {
  lights.editor.edit(look.name, recalled(lights.document(), look));
}

void editLooks(const LightsContext& lights, const std::string& step, std::vector<SavedLook> looks) {
  Document next = lights.document();
  next.looks = std::move(looks);
  lights.editor.edit(step, std::move(next));
}

void renameLook(const LightsContext& lights, size_t look, const std::string& name) {
  lights.editor.edit(lights.document().looks[look].name + ": rename",
                     withLookNamed(lights.document(), look, name));
}

void removeLook(const LightsContext& lights, size_t look) {
  const std::string name = lights.document().looks[look].name;
  const size_t before = lights.document().cues.size();
  lights.editor.edit("Remove " + name, withLookRemoved(lights.document(), look));
  const size_t gone = before - lights.document().cues.size();
  if (gone > 0)
    lights.messages.info(fmt::format("{} is removed, and {} with it. Undo brings both back.", name,
                                     gone == 1 ? "its cue" : fmt::format("its {} cues", gone)));
}

void replaceLook(const LightsContext& lights, size_t look) {
  const Document& document = lights.document();
  std::vector<SavedLook> looks = document.looks;
  const SavedLook& before = looks[look];
  SavedLook now = versionOf(document, before.name, before.note);
  if (!before.scene) now.scene.reset();
  looks[look] = std::move(now);
  editLooks(lights, document.looks[look].name + ": replace", std::move(looks));
}

void wipeAgainstLook(const LightsContext& lights, const SavedLook& look) {
  CompareState& compare = lights.view.compare;
  compare.subject = {};
  compare.rig = look.rig;
  compare.mode = CompareState::Mode::Wipe;
}

void previewCrossfade(const LightsContext& lights, const SavedLook& a, const SavedLook& b, float amount) {
  Document next = lights.document();
  const Stage from = stageOf(a, stageOfDocument(next));
  next = withStage(std::move(next), StageFade(from, stageOf(b, from)).at(amount));
  lights.editor.preview("Crossfade " + a.name + " – " + b.name, std::move(next));
}

}  // namespace swaplight
