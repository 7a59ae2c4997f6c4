#pragma once

#include <string>

#include "core/set/open_color.h"
#include "core/solve/calibration/swapped_color.h"

namespace swaplight {

/// Which of the line's colours is taken, by what the person has told, and why. Throws InputError where a
/// place lies outside of the picture or is dark, or where no colour of the line is as bright as was told.
[[nodiscard]] OpenColor chosenColor(const Capture& capture, const SwappedColor& swapped,
                                    const ShotSignal& signal, const SwappedColorLine& line,
                                    const OpenColorChoice& choice);

/// For a person: what is open, between which colours, what was taken and why, what would settle it.
[[nodiscard]] std::string wordsFor(const OpenColor& open);

}  // namespace swaplight
