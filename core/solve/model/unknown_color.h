#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/solve/model/lighting_matrix.h"

namespace swaplight {

/// A colour that nobody has told: one unknown, wherever it stands.
struct UnknownColor {
  std::string name;          ///< "?a"; "" where it stands in one place only and has no name
  std::vector<int> entries;  ///< shot * lights + light
};

/// The unknown colours of a capture, in the order of its shots and lights.
[[nodiscard]] std::vector<UnknownColor> unknownColorsOf(const Capture& capture);

/// "?a (fill in shot 1, key in shot 2)", "the colour of fill in shot 1".
[[nodiscard]] std::string wordsFor(const UnknownColor& unknown, const LightingMatrix& lighting);

/// Two lamps that have exchanged two gels between two shots, one gel known and one not.
struct SwappedColor {
  int shots[2];
  int lights[2];  ///< of the known gel in each of the shots
  /// Every shot of the capture is lit like one of these two: then one number of the unknown colour is open,
  /// however many pixels there are (docs/theory.md, Unknown colours).
  bool open;
};

/// The first such pair of shots; nothing where there is none. Unknowns of two names, or of none, that stand
/// where the one gel would are taken for it: gels that are nearly alike, as a start.
[[nodiscard]] std::optional<SwappedColor> swappedColorOf(const Capture& capture);

}  // namespace swaplight
