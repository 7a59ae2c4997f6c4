#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"

namespace swaplight {

/// How one lamp's colour drifts over the picture, as a solve found it.
struct LampField {
  std::string light;
  double size = 0;  ///< RMS over the picture and the channels, relative
  /// The lamp's colour over its mean, at luminance 1, in the corners: left and right above, left and right
  /// below.
  std::array<std::array<double, 3>, 4> corners{};
};

/// A report's "lamp_fields".
[[nodiscard]] Json jsonFromLampFields(const std::vector<LampField>& fields);
/// What is missing or no number is left out.
[[nodiscard]] std::vector<LampField> lampFieldsFromJson(const Json& json);

}  // namespace swaplight
