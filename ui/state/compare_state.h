#pragma once

#include <optional>

#include "core/base/json_fwd.h"
#include "core/relight/rig.h"
#include "core/view/view_subject.h"

namespace swaplight {

/// What the picture, A, is compared with, and how. Each side has a subject and a lighting of its own.
struct CompareState {
  enum class Mode { Off, Wipe, Split, Difference, OnlyB };
  Mode mode = Mode::Off;
  ViewSubject subject;      ///< of B
  std::optional<Rig> rig;   ///< of B, where it is relit: a lighting that was kept; empty: all white
  double x = 0.5, y = 0.5;  ///< a point of the wipe's line, as parts of the picture's width and height
  double angleDegrees = 0;

  [[nodiscard]] bool isOn() const { return mode != Mode::Off; }
};

[[nodiscard]] Json jsonFromCompareState(const CompareState& state);
/// Throws where a value cannot be.
[[nodiscard]] CompareState compareStateFromJson(const Json& json);

}  // namespace swaplight
