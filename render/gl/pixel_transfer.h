#pragma once

#include "core/image/image.h"
#include "render/gl/tiled_texture.h"

namespace swaplight {

/// Replaces a rectangle of a picture on the graphics card by planes R G B (or one that counts for all three),
/// rounded to half floats. Its left top pixel lies at x, y. Throws std::logic_error where it lies outside.
void updatePicture(TiledTexture& picture, ImageView pixels, int x, int y);

/// Reads R G B of a picture back from the graphics card. `out` has its size.
void readPicture(const TiledTexture& picture, ImageSpan out);

}  // namespace swaplight
