#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/filter/filter.h"

namespace swaplight {

/// A filter as OpenGL 4.1 compiles it.
///
/// Uniforms: ISF's own (RENDERSIZE, TIME, TIMEDELTA, DATE, FRAMEINDEX) and every input by its
/// name; of a curve X, which is a function, `isf_points_X` (vec3, kMostCurvePoints of them: x, y, slope) and
/// `isf_count_X`. SWAPLIGHT is defined. `isf_origin` (vec2) is the pixel of the pass at which its left bottom
/// corner lies: a tile's place. Every image X has `isf_window_X` (vec4): the pixel of X at which its texture
/// begins, and the size of all of X. `isf_bounds` (vec2): what results are clamped to. What is not a number
/// becomes `isf_notANumber` (float, 0 unless it is set).
struct GlslTranslation {
  std::string vertex, fragment;
  std::vector<std::string>
      images;                   ///< samplers: inputImage, inputs, targets, imports, the overview, the light
  bool looksElsewhere = false;  ///< it reads other pixels than the one it writes
};

struct TranslationOptions {
  bool maySkipBounds = false;  ///< loops stay as they are (the program's own filters are known to end)
  /// inputImage and targets are samplers of the kind sampler2DRect, which is right where the source reads
  /// images by IMG_ functions alone.
  bool rectangles = false;
  /// PASSINDEX as a constant: a processor that draws would go through the code of all passes. Without it a
  /// uniform, which some filters need: a constant may not index beyond an array, run or not.
  std::optional<int> pass = {};
};
[[nodiscard]] GlslTranslation translateFilter(const Filter& filter, const TranslationOptions& options = {});

/// An input's name as the translated shader has it: another one where GLSL 4.10 reserves the author's.
[[nodiscard]] std::string glslName(const std::string& name);

/// One line of a compiler's words that names the filter's own file and line: "soft.fs:12: ...", out of what
/// Mesa ("0:12(3): error: ..."), NVIDIA ("0(12) : error ...") and others print.
[[nodiscard]] std::string compileErrorLine(const std::string& log, const std::string& file);

}  // namespace swaplight
