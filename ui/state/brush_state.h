#pragma once

#include <memory>
#include <optional>

#include "core/edit/stack/edit.h"
#include "core/session/document.h"

namespace swaplight {

/// The brush in the person's hand, and the stroke that is under way.
struct BrushState {
  /// What the brush does to the chosen light.
  enum class Mode { Add, Remove, Soften, SetTo };
  Mode mode = Mode::Add;
  EnergyMode energy = EnergyMode::Add;
  float radius = 0;  ///< pixels of the picture; 0: not chosen yet, a part of the picture's height
  float hardness = 0.5F;
  float opacity = 1;
  float flow = 0.5F;
  float light = 0.5F;                      ///< that Add adds, as a part of the picture under all lights
  float level = 0.5F;                      ///< that SetTo sets the light's part to
  int softness = 16;                       ///< pixels over which Soften blurs
  bool erase = false;                      ///< takes paint off again
  bool edges = false;                      ///< stays on the surface under its middle
  std::shared_ptr<const EdgeGuide> guide;  ///< the picture that it then looks at

  /// A stroke under way.
  struct Going {
    Document before;
    size_t edit = 0;  ///< its place in the list
    Edit base;        ///< without the stroke
    Painting painting;
  };
  std::optional<Going> going;
  std::optional<StrokePoint> last;  ///< where the last stroke ended: straight lines begin there
};

}  // namespace swaplight
