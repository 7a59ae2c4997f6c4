#pragma once

#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// What a rendered picture shows.
struct BenchPicture {
  int width = 192;
  int height = 128;
  int lights = 2;
  float gloss = 0;  ///< 0 matte; 1: highlights brighter than the surfaces, and reflections of other objects
  bool bounced = false;  ///< light that has met one other surface too
  float shiftX = 0;      ///< pixels that the camera has turned to the right
  float shiftY = 0;
  bool moved = false;  ///< one of the balls lies elsewhere
};

/// The contribution of each light at unit white to a small still life: eight balls on a floor before a wall,
/// some plain, some striped, some speckled down to single pixels, hard and soft shadows, pixels mixed at
/// edges. Ray-cast, without noise, the same every time; a white surface facing a lamp is at about 0.5. Half
/// of the balls, of the floor and of the wall stay matte whatever the gloss.
[[nodiscard]] std::vector<Image> renderBenchPicture(const BenchPicture& picture);

/// The same set under an even white dome of radiance `level`.
[[nodiscard]] Image renderBenchAmbient(const BenchPicture& picture, float level);

}  // namespace swaplight
