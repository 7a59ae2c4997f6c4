#pragma once

#include <OpenImageIO/imageio.h>

#include "core/image/header_values.h"

namespace swaplight {

/// What of a header is about the picture and not about its file: what may be handed on to another file.
[[nodiscard]] HeaderValues headerValuesOf(const OIIO::ImageSpec& spec);

/// Puts the values into a header. Those that are there already stay.
void addHeaderValues(OIIO::ImageSpec& spec, const HeaderValues& values);

}  // namespace swaplight
