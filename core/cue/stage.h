#pragma once

#include <optional>
#include <set>
#include <string>

#include "core/edit/stack/edit.h"
#include "core/edit/stack/edit_fade.h"
#include "core/look/saved_look.h"
#include "core/relight/rig.h"

namespace swaplight {

/// What a cue changes: the lights and what was done to them.
struct Stage {
  Rig rig;
  EditStack edits;
  bool operator==(const Stage&) const = default;
};

/// What a look or version of the gallery makes of a stage. A look is a lighting: the edits stay, and lights
/// that it does not know. A version has edits of its own, and with them the lights that they add.
[[nodiscard]] Stage stageOf(const SavedLook& look, const Stage& now);

/// The way from one stage to another, as dimmers go it: every light's factor in a straight line in linear
/// light (blendRigs), edits by their opacity (EditFade). Lights that edits add on one side come out of, and
/// go into, the dark.
class StageFade {
 public:
  StageFade(Stage from, Stage to);

  /// amount 0..1; at 0 and 1 the stages as they are.
  [[nodiscard]] Stage at(float amount) const;
  [[nodiscard]] const Stage& to() const { return m_to; }
  /// Whether anything but these lights goes from one side to the other.
  [[nodiscard]] bool movesBeside(const std::set<std::string>& lights) const;

 private:
  Stage m_from, m_to;
  Rig m_fromAll, m_toAll;  ///< with the lights of both
  EditFade m_edits;
};

/// The lights that have other settings in one rig than in the other; nothing where the rigs differ in more
/// than the settings of lights: which ones there are, groups, ambient light.
[[nodiscard]] std::optional<std::set<std::string>> changedLights(const Rig& before, const Rig& now);
/// A rig in which some lights are set as they are in another.
[[nodiscard]] Rig withLightsAsIn(const Rig& other, const std::set<std::string>& lights, Rig rig);

/// The same light without groups, solo and mute: every light's own setting says what it gives, so that keys
/// of single lights can say all.
[[nodiscard]] Rig withoutGroups(Rig rig);

}  // namespace swaplight
