#include "ui/camera/lit_frame.h"

#include <algorithm>
#include <cmath>

#include "core/view/window_pixels.h"

namespace swaplight {
namespace {

int scaledSide(int side, float scale) {
  constexpr double kRounding = 1e-3;  // of the scale's float
  return std::max(1, static_cast<int>(std::ceil(double{scale} * side - kRounding)));
}

}  // namespace

Image litFrame(const SeenRequest& request, float scale) {
  const LiveSet::Reading reading = request.live->read();
  const int width = reading.pictures().width(), height = reading.pictures().height();
  Image light(ImageSpec::rgb(scaledSide(width, scale), scaledSide(height, scale)));
  windowLinear(reading.pictures().layers({}, request.factors, request.ambient),
               {0, 0, scale, light.width(), light.height()}, light.span());
  light.setColorSpace(reading.set().colorSpace());
  return light;
}

}  // namespace swaplight
