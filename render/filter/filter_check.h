#pragma once

#include <memory>
#include <string>

#include "render/filter/pipeline_renderer.h"

namespace swaplight {

/// Draws a filter with its defaults and, one after the other, with every parameter at both of its ends and in
/// every choice, on light from 0 to 65504, on negative and missing values, and on fine detail whole and in
/// parts. Says in a line the first thing that is wrong, nothing where all is right:
/// - it computes no number (0 / 0, the root or power of negative light), which would be a black pixel;
/// - it computes what is too bright for any number;
/// - it looks further than its HALO, so that a large frame shows the seams of its parts.
/// A filter without the key SWAPLIGHT assumes codes 0 to 1, and is tried with its defaults alone. In the
/// current OpenGL context. Throws InputError where it does not compile or takes longer than `mostSeconds`.
[[nodiscard]] std::string faultOf(const std::shared_ptr<const Filter>& filter, double mostSeconds);

}  // namespace swaplight
