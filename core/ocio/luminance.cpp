#include "core/ocio/luminance.h"

#include <array>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace swaplight {
namespace {

/// ITU-R BT.709: linear R, G, B to XYZ. Its middle row is kRec709Luminance.
constexpr glm::mat3 kXyzFromRec709{0.4124F, 0.2126F, 0.0193F,   // red
                                   0.3576F, 0.7152F, 0.1192F,   // green
                                   0.1805F, 0.0722F, 0.9505F};  // blue

bool near(const glm::mat3& a, const glm::mat3& b) {
  for (int column = 0; column < 3; ++column)
    if (glm::any(glm::greaterThan(glm::abs(a[column] - b[column]), glm::vec3(1e-3F)))) return false;
  return true;
}

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

std::optional<Chromaticities> chromaticitiesIn(const ColorConfig& config, const std::string& colorSpace) {
  const glm::mat3 xyz = xyzFromLinear(config, colorSpace);
  for (const char* published : {"lin_rec709", "acescg", "aces2065_1"})
    if (near(xyz, xyzFromLinear(config, published))) return chromaticitiesOf(published);
  Chromaticities xy;
  const std::array<glm::vec3, 4> colors = {xyz[0], xyz[1], xyz[2], xyz[0] + xyz[1] + xyz[2]};
  for (size_t i = 0; i < colors.size(); ++i) {
    const float sum = colors[i].x + colors[i].y + colors[i].z;
    if (!(sum > 0)) return std::nullopt;
    xy[2 * i] = colors[i].x / sum;
    xy[2 * i + 1] = colors[i].y / sum;
  }
  return xy;
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
