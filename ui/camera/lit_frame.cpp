#include "ui/camera/lit_frame.h"

#include <algorithm>
#include <cmath>

#include "core/relight/relative_light.h"
#include "core/view/window_pixels.h"

namespace swaplight {
namespace {

int scaledSide(int side, float scale) {
  constexpr double kRounding = 1e-3;  // of the scale's float
  return std::max(1, static_cast<int>(std::ceil(double{scale} * side - kRounding)));
}

Image frameOf(const LiveSet::Reading& reading, const std::vector<Rgb>& factors, float ambient, float scale) {
  const int width = reading.pictures().width(), height = reading.pictures().height();
  Image light(ImageSpec::rgb(scaledSide(width, scale), scaledSide(height, scale)));
  windowLinear(reading.pictures().layers({}, factors, ambient), {0, 0, scale, light.width(), light.height()},
               light.span());
  light.setColorSpace(reading.set().colorSpace());
  return light;
}

}  // namespace

Image litFrame(const SeenRequest& request, float scale) {
  return frameOf(request.live->read(), request.factors, request.ambient, scale);
}

Image relativeLight(const SeenRequest& request, float scale) {
  const LiveSet::Reading reading = request.live->read();
  const int longest = std::max(reading.pictures().width(), reading.pictures().height());
  scale = std::min(scale, static_cast<float>(kRelativeLightSide) / static_cast<float>(longest));
  const std::vector<Rgb> unit(request.factors.size(), Rgb(1));
  return relativeLight(frameOf(reading, request.factors, request.ambient, scale),
                       frameOf(reading, unit, 1, scale));
}

}  // namespace swaplight
