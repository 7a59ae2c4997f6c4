#pragma once

#include "core/ocio/display_choice.h"

namespace swaplight {

/// What of the colour is shown.
enum class ViewChannel { Color, Red, Green, Blue, Luminance };

/// Stripes over what is darker or brighter than a display code value, 0..1.
struct Zebra {
  bool on = false;
  float low = 0.0F;
  float high = 0.95F;
  bool operator==(const Zebra&) const = default;
};

/// How a scene-linear picture is brought to the monitor. Exposure and gamma are the viewer's own: they are
/// never part of what is exported.
///
///   code = pow(view(rgb * 2^exposureStops), 1 / gamma), then channel, false colour or zebra
struct ViewSettings {
  DisplayChoice display;
  float exposureStops = 0;
  float gamma = 1;  ///< > 0
  ViewChannel channel = ViewChannel::Color;
  bool falseColor = false;  ///< stops from middle grey as colours, instead of the view
  Zebra zebra;
  bool operator==(const ViewSettings&) const = default;

  [[nodiscard]] bool neutral() const { return exposureStops == 0 && gamma == 1; }
};

}  // namespace swaplight
