#pragma once

#include <cstdint>
#include <vector>

#include "core/image/image.h"
#include "render/tiled_texture.h"

namespace swaplight {

/// R G B planes as interleaved half floats R G B 1, row after row: what textures are filled from.
[[nodiscard]] std::vector<uint16_t> halfRgbaFromPlanes(ImageView rgb);

/// Reads R G B of a picture back from the graphics card. `out` has its size.
void readTiles(const TiledTexture& picture, ImageSpan out);

/// Fills a picture on the graphics card from R G B planes of its size.
void uploadTiles(TiledTexture& picture, ImageView rgb);

}  // namespace swaplight
