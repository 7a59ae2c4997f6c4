#pragma once

#include "core/image/image.h"

namespace swaplight {

/// What is no number, or so much light (above 1e25) that frames would be infinite, becomes 0. Returns how
/// many values that were, over all channels.
size_t makeFinite(Image& image);

}  // namespace swaplight
