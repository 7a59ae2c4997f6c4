#pragma once

#include "core/edit/mask/mask_context.h"

namespace swaplight {

/// The parts put together one after the other (add: the larger, subtract: what is left, intersect: the
/// smaller of the two), then softened over `feather` pixels. Throws as the context does.
[[nodiscard]] MaskRaster drawSelection(const SelectionShape& shape, MaskContext& context);

}  // namespace swaplight
