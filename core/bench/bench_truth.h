#pragma once

#include "core/set/solved_set.h"

namespace swaplight {

/// The truth of a capture as a solved set. Throws InputError where it has none.
[[nodiscard]] SolvedSet benchTruth(const Capture& capture);

/// The same from contributions that are known.
[[nodiscard]] SolvedSet benchTruth(const Capture& capture, const std::vector<Image>& contributions);

}  // namespace swaplight
