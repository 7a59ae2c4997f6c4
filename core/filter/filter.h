#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/filter/filter_value.h"

namespace swaplight {

/// What a filter's pixels mean.
enum class FilterSpace {
  SceneLinear,  ///< light: linear, 1 is a white surface, highlights go on above
  Display,      ///< code values of a view, 0..1: what a plain ISF filter's author assumed
  Any           ///< moves or covers pixels, and leaves their values alone: works in either
};
[[nodiscard]] const char* filterSpaceName(FilterSpace space);

/// A parameter of a filter, or a picture that it reads.
struct FilterInput {
  std::string name;     ///< as the shader calls it
  std::string label;    ///< for people; the name where the file gives none
  std::string tooltip;  ///< one line; may be empty
  std::string unit;     ///< "stops", "px of 1920", "K" ...; may be empty
  FilterInputType type = FilterInputType::Float;
  FilterValue standard;                  ///< the default
  std::optional<FilterValue> low, high;  ///< of a vector, matrix or curve a number: that of each of theirs
  std::vector<int> values;               ///< of a choice
  std::vector<std::string> labels;       ///< of a choice's values

  /// A value that is the input's own, or InputError: of another type, out of range, no such choice. A plain
  /// ISF file's MIN and MAX are what its sliders show, and are not enforced (`strict` false).
  void check(const FilterValue& value, const std::string& where, bool strict) const;
};

/// A pass of several: where it draws to, and how large that is.
struct FilterPass {
  std::string target;            ///< the image that later passes read by this name; empty: the result
  std::string widthExpression;   ///< empty: the frame's
  std::string heightExpression;  ///< empty: the frame's
  bool isFloat = false;          ///< values beyond 0..1 are kept
  bool persistent = false;       ///< keeps the frame before; at one frame it begins as black
};

/// A picture that comes with the filter.
struct FilterImport {
  std::string name;
  std::filesystem::path file;
};

/// A camera shader: one file of GLSL with a JSON header, after the Interactive Shader Format 2
/// (https://docs.isf.video), read unchanged, and one optional key "SWAPLIGHT" that other programs ignore:
///
///   "SWAPLIGHT": {
///     "SPACE": "scene_linear" | "display" | "any",   without the key: display
///     "HALO": 12 or "ceil(3 * $radius * $WIDTH / 1920)",  how far a pixel looks, in pixels of the frame;
///                                                     without: the filter sees the whole frame at once
///     "SAMPLING": "nearest",                          IMG_PIXEL reads one pixel; without: interpolates
///     "OVERVIEW": "overview",                         the name of an image that holds the frame's averages,
///                                                     at most kOverviewSide pixels a side
///     "LIGHT": "setLight",                            the name of an image that holds, over the whole frame,
///                                                     how much more the set's lights give than at unit white
///                                                     (FilteredImage::light); one pixel, black, where no
///                                                     lights are known
///     "WHERE": ["shot", "light", "frame"],            where a pipeline may use it; without: frame
///     "INPUTS": [{"NAME": "gains", "TYPE": "vector", "DEFAULT": [1, 1, 1], "MIN": 0, "MAX": 4}],
///                                                     parameters of the types vector (vec2 to vec4), matrix
///                                                     (mat2 to mat4) and curve (a function: float f(float))
///     "UNIT": {"radius": "px of 1920"}, "TOOLTIP": {"radius": "..."}
///   }
struct Filter {
  std::string name;  ///< the file's, without ".fs"
  std::filesystem::path file;
  std::string description, credit;
  std::vector<std::string> categories;
  std::vector<FilterInput> inputs;  ///< without inputImage
  std::vector<FilterPass> passes;   ///< at least one
  std::vector<FilterImport> imports;
  bool takesImage = false;  ///< it has the input inputImage: a filter, not a generator
  bool ours = false;        ///< it has the key SWAPLIGHT
  bool builtIn = false;     ///< it came with the program
  FilterSpace space = FilterSpace::Display;
  std::optional<std::string> halo;  ///< an expression, in pixels; nothing: the whole frame
  bool nearest = false;
  std::string overview;  ///< the image's name; empty: none
  std::string light;     ///< the image's name; empty: none
  std::vector<std::string> where = {"frame"};
  std::vector<std::string> notes;  ///< what of it has no meaning for a still picture, for people

  std::string source;        ///< GLSL behind the header
  int sourceLine = 1;        ///< the line of the file with which it begins
  std::string vertexSource;  ///< of the .vs beside it; may be empty

  [[nodiscard]] const FilterInput* findInput(const std::string& inputName) const;
};

/// The longest side of a filter's overview of the frame.
inline constexpr int kOverviewSide = 256;

}  // namespace swaplight
