#include "ui/camera/lit_frame.h"

#include <algorithm>
#include <cmath>

#include "core/view/window_pixels.h"

namespace swaplight {
namespace {

int scaledSide(int side, float scale) {
  return std::max(1, static_cast<int>(std::lround(scale * static_cast<float>(side))));
}

}  // namespace

Image litFrame(const SeenRequest& request, float scale) {
  const LiveSet::Reading reading = request.live->read();
  const int width = reading.pictures().width(), height = reading.pictures().height();
  Image light(ImageSpec::rgb(scaledSide(width, scale), scaledSide(height, scale)));
  const double zoom =
      std::max(static_cast<double>(light.width()) / width, static_cast<double>(light.height()) / height);
  windowLinear(reading.pictures().layers({}, request.factors, request.ambient),
               {0, 0, zoom, light.width(), light.height()}, light.span());
  light.setColorSpace(reading.set().colorSpace());
  return light;
}

}  // namespace swaplight
