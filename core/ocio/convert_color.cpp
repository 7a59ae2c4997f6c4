#include "core/ocio/convert_color.h"

#include "core/image/image.h"

namespace swaplight {

Rgb convertColor(const ColorConfig& config, const Rgb& color, const std::string& from,
                 const std::string& to) {
  if (from == to) return color;
  Image pixel(ImageSpec::rgb(1, 1));
  for (int c = 0; c < 3; ++c) pixel.plane(c)[0] = color[c];
  config.convert(pixel.span(), from, to);
  return {pixel.plane(0)[0], pixel.plane(1)[0], pixel.plane(2)[0]};
}

}  // namespace swaplight
