#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "core/edit/mask/selection.h"

namespace swaplight {

/// The dashes of the outline march a step in such a time.
constexpr std::chrono::milliseconds kMarchStep{150};

/// How the next part of the selection is made, and the outline of what is selected.
struct SelectionState {
  enum class Kind { Lasso, Rectangle, Ellipse, Similar, Shadow };
  Kind kind = Kind::Lasso;
  SimilarShape::By by = SimilarShape::By::Color;
  float tolerance = 0.08F;
  bool connected = true;

  /// A gesture under way: the points of the picture where the mouse was.
  struct Going {
    SelectHow how = SelectHow::Replace;
    std::vector<std::array<float, 2>> points;
  };
  std::optional<Going> going;

  Mask outlined;  ///< what `outline` is of
  bool outlineKnown = false;
  std::shared_ptr<const MaskRaster> raster;  ///< kept, so that edits find it drawn
  std::vector<std::vector<std::array<float, 2>>> outline;
  bool marching = false;  ///< the last frame has drawn its dashes
};

}  // namespace swaplight
