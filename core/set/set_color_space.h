#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/ocio/color_config.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// A set in other primaries (lin_rec709, acescg, aces2065_1), white adapted (Bradford): a light at unit white
/// is unit white there. Shares and quality stay. Colours that the new primaries cannot mix are cut off at 0.
/// Nothing changes where the space is empty or the set's own. Throws InputError for any other space; Stopped.
[[nodiscard]] SolvedSet inColorSpace(const ColorConfig& config, SolvedSet set, const std::string& colorSpace,
                                     const Progress& progress = {});
/// The same for a copy.
[[nodiscard]] SolvedSet copyInColorSpace(const ColorConfig& config, const SolvedSet& set,
                                         const std::string& colorSpace, const Progress& progress = {});
/// "linear Rec.709", "ACEScg", "ACES2065-1": a set's space in words; others as they are called.
[[nodiscard]] std::string setColorSpaceWords(const std::string& colorSpace);
/// Throws as inColorSpace does, before there is a set.
void checkSetColorSpace(const std::string& colorSpace);

}  // namespace swaplight
