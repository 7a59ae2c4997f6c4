#pragma once

#include <string>

#include "core/solve/solved_set.h"

namespace swaplight {

/// A set in other primaries (lin_rec709, acescg, aces2065_1), white adapted (Bradford): a light at unit white
/// is unit white there. Shares and quality stay. Colours that the new primaries cannot mix are cut off at 0.
/// Throws InputError for any other space.
[[nodiscard]] SolvedSet inColorSpace(SolvedSet set, const std::string& colorSpace);
/// Throws as that does, before there is a set.
void checkSetColorSpace(const std::string& colorSpace);

}  // namespace swaplight
