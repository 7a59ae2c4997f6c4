#pragma once

#include <string>
#include <vector>

#include "core/edit/stack/edit.h"

namespace swaplight {

/// What of a stack of edits holds for the same lamps seen from elsewhere.
struct PlaceFreeEdits {
  EditStack edits;                   ///< for a picture of any size
  std::vector<std::string> leftOut;  ///< names of edits that are on; and what was said of places by clicks
};

/// Edits that act on whole lights, on all of a light's shadows, or by a colour stay. Those with a place in
/// the picture (painted, drawn, selected by a click), those made of a picture's pixels (beta maps, a gel that
/// two photographs left open) and moved lamps, whose lengths are widths of the picture, do not, nor do those
/// of lights that are not among `lights`. A new light stays where an edit of it does.
[[nodiscard]] PlaceFreeEdits placeFreeEdits(const EditStack& stack, const std::vector<std::string>& lights);

}  // namespace swaplight
