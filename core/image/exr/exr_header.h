#pragma once

#include <openexr.h>

#include "core/image/image_parts.h"

namespace swaplight {

/// The required attributes of a part: windows, pixel aspect, screen window.
[[nodiscard]] exr_result_t setExrWindows(exr_context_t exr, int part, const FileToWrite& contents,
                                         exr_compression_t compression);

/// Text and carried values under the names that OpenEXR gives them.
[[nodiscard]] exr_result_t setExrValues(exr_context_t exr, int part, const FileToWrite& contents);

}  // namespace swaplight
