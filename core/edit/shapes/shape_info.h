#pragma once

namespace swaplight {

/// What a shape is called.
struct ShapeInfo {
  const char* name;   ///< in files
  const char* title;  ///< in the studio: where an edit acts
};

/// How the studio offers a shape as a stencil, which a drag in the picture places.
struct StencilInfo {
  const char* label;  ///< of the button
  const char* tip;
};

}  // namespace swaplight
