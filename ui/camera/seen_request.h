#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/color/rgb.h"
#include "core/filter/filter_pipeline.h"
#include "core/ocio/color_config.h"
#include "core/ocio/display_choice.h"
#include "ui/pictures/live_set.h"

namespace swaplight {

/// All that a frame under a camera look follows from.
struct SeenRequest {
  std::shared_ptr<const ColorConfig> config;
  std::shared_ptr<const LiveSet> live;
  uint64_t pixels = 0;       ///< another number: pixels of the set have changed
  std::vector<Rgb> factors;  ///< the rig's
  float ambient = 1;
  FilterPipeline look;
  DisplayChoice display;  ///< the view in which filters for a display work
  bool operator==(const SeenRequest&) const = default;
};

}  // namespace swaplight
