#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/edit/apply/prepared_edit.h"

namespace swaplight {

/// The edits that come before one in the stack.
using EarlierEdits = std::vector<std::shared_ptr<const PreparedEdit>>;

/// How far an edit of a lamp goes beyond what can be known of it. Measured on a grid of the picture.
struct LampLimits {
  /// Of the picture's area: where at least half of the light is a guess, because it comes to what its lamp
  /// never lit. 0..1.
  double guessed = 0;
  /// How far the lamp moves, over the width of what it lights, together with the moves of earlier edits where
  /// both act: beyond kFarthest its shadows, which keep their shape, are in the wrong place. A lamp that
  /// turns in its place throws the same ones.
  double shift = 0;

  /// The lamp turns, together with the turns of earlier edits, until the middle of its light lies outside the
  /// picture: what of its beam lights the picture then lay outside it before.
  bool turnsOut = false;

  /// Of a spot's cone: what lies in the picture, 0..1. What is mostly outside tells little of its lamp.
  double seen = 1;

  static constexpr double kLeastSeen = 0.5;
  static constexpr double kFarthest = 0.25;   ///< what moves were measured to be good for: docs/edits.md
  static constexpr double kGuessTold = 0.01;  ///< smaller areas are not worth a word
};

/// `k` is an index of the edit's chosen lights.
[[nodiscard]] LampLimits lampLimits(const PreparedEdit& edit, size_t k, const EditedLights& lights,
                                    const EarlierEdits& earlier = {});

/// In words, of edits of lamps and of places; nothing where the edit stays within its limits, or is another.
[[nodiscard]] std::vector<std::string> lampWarnings(const PreparedEdit& edit, const EditedLights& lights,
                                                    const EarlierEdits& earlier = {});

}  // namespace swaplight
