#include "core/view/luminance.h"

#include <glm/geometric.hpp>

namespace swaplight {

Rgb luminanceWeights(const ColorConfig& config, const std::string& colorSpace) {
  // The luminance of each primary, all three as pixels of one picture.
  Image primaries(ImageSpec::rgb(3, 1), 0);
  for (int c = 0; c < 3; ++c) primaries.plane(c)[c] = 1;
  config.convert(primaries.span(), colorSpace, "lin_rec709");
  Rgb weights(0);
  for (int c = 0; c < 3; ++c)
    weights[c] =
        glm::dot(kRec709Luminance, Rgb(primaries.plane(0)[c], primaries.plane(1)[c], primaries.plane(2)[c]));
  return weights;
}

}  // namespace swaplight
