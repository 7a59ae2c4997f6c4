#pragma once

#include <vector>

#include "core/filter/glsl/glsl_tokens.h"

namespace swaplight {

/// The most turns that all loops of one pixel take together where nothing in the source bounds them.
inline constexpr int kMostLoopTurns = 65536;

/// Gives every loop a bound: its condition also asks `isf_go()`, which the translation declares and which
/// counts the turns of a pixel. Loops that plainly end (for (int i = 0; i < 8; ++i), to at most 256, without
/// a loop inside) stay as they are, because compilers unroll them. Returns whether a loop was changed.
bool boundLoops(std::vector<GlslToken>& tokens);

}  // namespace swaplight
