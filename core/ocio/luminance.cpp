#include "core/ocio/luminance.h"

namespace swaplight {
namespace {

/// ITU-R BT.709: linear R, G, B to XYZ. Its middle row is kRec709Luminance.
constexpr glm::mat3 kXyzFromRec709{0.4124F, 0.2126F, 0.0193F,   // red
                                   0.3576F, 0.7152F, 0.1192F,   // green
                                   0.1805F, 0.0722F, 0.9505F};  // blue

}  // namespace

glm::mat3 xyzFromLinear(const ColorConfig& config, const std::string& colorSpace) {
  // What each primary is in Rec.709, all three as pixels of one picture.
  Image primaries(ImageSpec::rgb(3, 1), 0);
  for (int c = 0; c < 3; ++c) primaries.plane(c)[c] = 1;
  config.convert(primaries.span(), colorSpace, "lin_rec709");
  glm::mat3 rec709(0);
  for (int primary = 0; primary < 3; ++primary)
    for (int c = 0; c < 3; ++c) rec709[primary][c] = primaries.plane(c)[primary];
  return kXyzFromRec709 * rec709;
}

Rgb luminanceWeights(const ColorConfig& config, const std::string& colorSpace) {
  const glm::mat3 xyz = xyzFromLinear(config, colorSpace);
  return {xyz[0].y, xyz[1].y, xyz[2].y};
}

Rgb luminanceWeights(const std::string& colorSpace) {
  static const ColorConfig builtin("");
  return luminanceWeights(builtin, colorSpace);
}

}  // namespace swaplight
