#include "core/view/display/exact_view.h"

#include "core/ocio/color_config_impl.h"

namespace swaplight {

ViewFunction exactView(const ColorConfig& config, const std::string& colorSpace,
                       const DisplayChoice& choice) {
  const OCIO::ConstCPUProcessorRcPtr exact = config.impl().view(colorSpace, namedDisplay(config, choice));
  return [exact](ImageSpan pixels) {
    if (!exact) return;
    constexpr auto kFloat = static_cast<ptrdiff_t>(sizeof(float));
    OCIO::PlanarImageDesc planes(pixels.row(0, 0), pixels.row(1, 0), pixels.row(2, 0), nullptr, pixels.width,
                                 pixels.height, OCIO::BIT_DEPTH_F32, kFloat, pixels.rowStride * kFloat);
    exact->apply(planes);
  };
}

}  // namespace swaplight
