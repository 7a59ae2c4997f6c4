#include "core/view/seen_exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/quantile.h"
#include "core/view/window_pixels.h"

namespace swaplight {
namespace {

constexpr int kSide = 240;  // pixels of the longer side: lamps in the picture are small
constexpr double kBrightPart = 0.99;
constexpr float kBright = 0.7F;

}  // namespace

std::optional<float> stopsToSee(std::span<const ViewLayer> layers) {
  if (layers.empty()) return std::nullopt;
  const int width = layers.front().picture->width(), height = layers.front().picture->height();
  const double zoom = std::min(1., 1. * kSide / std::max(width, height));
  const auto side = [&](int pixels) { return std::max(1, static_cast<int>(std::floor(zoom * pixels))); };
  Image light(ImageSpec::rgb(side(width), side(height)));
  windowLinear(layers, {0, 0, zoom, light.width(), light.height()}, light.span());
  std::vector<float> brightest(light.pixelCount());
  for (size_t p = 0; p < brightest.size(); ++p)
    brightest[p] = std::max({light.plane(0)[p], light.plane(1)[p], light.plane(2)[p]});
  const float bright = quantile(std::span(brightest), kBrightPart);
  if (!(bright > 0)) return std::nullopt;
  return std::log2(kBright / bright);
}

}  // namespace swaplight
