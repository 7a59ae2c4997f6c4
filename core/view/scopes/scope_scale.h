#pragma once

#include <string>
#include <vector>

#include "core/ocio/display_luminance.h"

namespace swaplight {

/// What a scope's scale of display codes is written in. All are full range.
enum class ScopeUnit { Codes8, Codes10, Percent, Nits };

struct ScopeTick {
  float place = 0;  ///< the code, 0..1
  std::string text;
};

/// The lines of such a scale, from the bottom. Nits where the display's luminance is known, else per cent.
[[nodiscard]] std::vector<ScopeTick> scopeTicks(ScopeUnit unit, const DisplayLuminance& shown);

}  // namespace swaplight
