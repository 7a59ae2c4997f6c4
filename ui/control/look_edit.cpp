#include "ui/control/look_edit.h"

#include "core/base/error.h"
#include "core/look/rig_blend.h"
#include "ui/control/light_edit.h"

namespace swaplight {

const LightRatios& lightRatios(StudioContext& studio) {
  LookState& state = studio.looks;
  if (state.ratiosOfSet != studio.session.setRevision()) {
    state.ratios = LightRatios(*studio.set()->solved);
    state.ratiosOfSet = studio.session.setRevision();
  }
  return state.ratios;
}

void applyPreset(StudioContext& studio, const Look& look) {
  // Another preset instead of one that is being tried: both are over what was before.
  const LookState::Blend* tried = activeBlend(studio);
  const Rig before = tried ? tried->before : studio.document().rig;
  try {
    const Rig whole = applyLook(before, look, lightRatios(studio));
    editRig(studio, look.name, whole);
    if (leavesDark(whole))
      studio.messages.info(
          "No light comes from behind in this set, and " + look.name +
          " leaves the others dark. Give a light the role back below, or paint a new light on "
          "the background (Shift+B).");
    studio.looks.blend = LookState::Blend{look.name, before, whole, whole, 1};
  } catch (const InputError& error) {
    studio.messages.error(error.what());
  }
}

const LookState::Blend* activeBlend(const StudioContext& studio) {
  const std::optional<LookState::Blend>& blend = studio.looks.blend;
  return blend && blend->shown == studio.document().rig ? &*blend : nullptr;
}

void previewBlend(StudioContext& studio, float amount) {
  LookState::Blend& blend = *studio.looks.blend;
  blend.amount = amount;
  blend.shown = blendRigs(blend.before, blend.whole, amount);
  Document next = studio.document();
  next.rig = blend.shown;
  studio.editor.preview(blend.name + ": amount", std::move(next));
}

void keepLook(StudioContext& studio) {
  std::vector<SavedLook> looks = studio.document().looks;
  const std::string name = freeLookName(looks);
  looks.push_back({name, "", studio.document().rig});
  editLooks(studio, "Keep " + name, std::move(looks));
}

void recallLook(StudioContext& studio, const SavedLook& look) {
  editRig(studio, look.name, blendRigs(studio.document().rig, look.rig, 1));
}

void editLooks(StudioContext& studio, const std::string& step, std::vector<SavedLook> looks) {
  Document next = studio.document();
  next.looks = std::move(looks);
  studio.editor.edit(step, std::move(next));
}

void wipeAgainstLook(StudioContext& studio, const SavedLook& look) {
  CompareState& compare = studio.view.compare;
  compare.subject = {};
  compare.rig = look.rig;
  compare.mode = CompareState::Mode::Wipe;
}

void previewCrossfade(StudioContext& studio, const SavedLook& a, const SavedLook& b, float amount) {
  Document next = studio.document();
  next.rig = blendRigs(blendRigs(next.rig, a.rig, 1), b.rig, amount);
  studio.editor.preview("Crossfade " + a.name + " – " + b.name, std::move(next));
}

}  // namespace swaplight
