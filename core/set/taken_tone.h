#pragma once

#include <array>
#include <vector>

#include "core/base/json_fwd.h"

namespace swaplight {

/// A tone curve that a capture does not tell of and that was taken off its photographs.
struct TakenTone {
  double exponent = 1;                      ///< the power of light that the files held, over middle values
  std::vector<std::array<float, 2>> curve;  ///< {value of the files as declared, light}, linear, full scale 1
};

/// A report's "tone_correction".
[[nodiscard]] Json jsonFromTakenTone(const TakenTone& tone);
/// What is missing or no number is left out.
[[nodiscard]] TakenTone takenToneFromJson(const Json& json);

}  // namespace swaplight
