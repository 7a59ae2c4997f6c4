#include "ui/control/look_edit.h"

#include "core/base/error.h"
#include "core/look/rig_blend.h"
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

void applyPreset(const LightsContext& lights, const Look& look) {
  // Another preset instead of one that is being tried: both are over what was before.
  const LookState::Blend* tried = activeBlend(lights);
  const Rig before = tried ? tried->before : lights.document().rig;
  try {
    const Rig whole = applyLook(before, look, lightRatios(lights));
    editRig(lights, look.name, whole);
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

void keepLook(const LightsContext& lights) {
  std::vector<SavedLook> looks = lights.document().looks;
  const std::string name = freeLookName(looks);
  looks.push_back({name, "", lights.document().rig});
  editLooks(lights, "Keep " + name, std::move(looks));
}

void recallLook(const LightsContext& lights, const SavedLook& look) {
  editRig(lights, look.name, blendRigs(lights.document().rig, look.rig, 1));
}

void editLooks(const LightsContext& lights, const std::string& step, std::vector<SavedLook> looks) {
  Document next = lights.document();
  next.looks = std::move(looks);
  lights.editor.edit(step, std::move(next));
}

void wipeAgainstLook(const LightsContext& lights, const SavedLook& look) {
  CompareState& compare = lights.view.compare;
  compare.subject = {};
  compare.rig = look.rig;
  compare.mode = CompareState::Mode::Wipe;
}

void previewCrossfade(const LightsContext& lights, const SavedLook& a, const SavedLook& b, float amount) {
  Document next = lights.document();
  next.rig = blendRigs(blendRigs(next.rig, a.rig, 1), b.rig, amount);
  lights.editor.preview("Crossfade " + a.name + " – " + b.name, std::move(next));
}

}  // namespace swaplight
