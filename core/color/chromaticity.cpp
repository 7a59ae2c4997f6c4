#include "core/color/chromaticity.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace swaplight {
namespace {

/// XYZ of luminance 1.
glm::dvec3 xyzFromXy(const Chromaticity& xy) {
  return {xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y};
}

/// The primaries of ITU-R BT.709, scaled so that equal amounts give its white (SMPTE RP 177).
glm::dmat3 makeXyzFromRec709() {
  const glm::dmat3 primaries(xyzFromXy({0.64, 0.33}), xyzFromXy({0.30, 0.60}), xyzFromXy({0.15, 0.06}));
  const glm::dvec3 scale = glm::inverse(primaries) * xyzFromXy(kD65);
  return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

const glm::dmat3 kXyzFromRec709 = makeXyzFromRec709();
const glm::dmat3 kRec709FromXyz = glm::inverse(kXyzFromRec709);

}  // namespace

Uv uvFromXy(const Chromaticity& xy) {
  const double d = -2 * xy.x + 12 * xy.y + 3;
  return {4 * xy.x / d, 6 * xy.y / d};
}

Chromaticity xyFromUv(const Uv& uv) {
  const double d = 2 * uv.u - 8 * uv.v + 4;
  return {3 * uv.u / d, 2 * uv.v / d};
}

float luminance(const Rgb& rec709) {
  return static_cast<float>((kXyzFromRec709 * glm::dvec3(rec709)).y);
}

Rgb rec709FromXy(const Chromaticity& xy) {
  const Rgb rgb = glm::max(kRec709FromXyz * xyzFromXy(xy), glm::dvec3(0));
  return rgb / luminance(rgb);
}

Chromaticity xyFromRec709(const Rgb& rec709) {
  const glm::dvec3 xyz = kXyzFromRec709 * glm::dvec3(rec709);
  const double sum = xyz.x + xyz.y + xyz.z;
  if (!(sum > 0)) return kD65;
  return {xyz.x / sum, xyz.y / sum};
}

}  // namespace swaplight
