#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/marks/mark_tuning.h"
#include "core/shadow/result/shadow_mark.h"

namespace swaplight {

/// What is known without marks; float pictures of one size, of any.
struct MarkedSurface {
  cv::Mat shading;        ///< log, as in ShadowEvidence
  cv::Mat borders;        ///< as ShadowSides::own
  cv::Mat evidence = {};  ///< log-odds that the light arrives; empty: nothing is known
};

/// What a light's marks say of every pixel: a float picture, from -1 (in shadow) over 0 (nothing) to 1 (lit);
/// an empty one without marks. In the marked pixels it is -1 or 1.
///
/// A mark speaks for the surface around it, not for a pixel. On one surface a light's shading falls with how
/// much of the light arrives: so "lit" says the same of all that is as bright there, and "shadow" of all that
/// is as dark; half a stop for noise. It says less the farther it is, and less beyond borders that only this
/// light has: what lies behind a cast edge is another matter. A mark says that the evidence is wrong where it
/// is, and so of evidence that is no stronger; of what speaks more against it, it says less, and through what
/// speaks against it, it does not go far. So a click on a thin shadow does not take the lit floor around it.
///
/// `picture`: the size of the picture whose pixels the marks name, all of them inside it.
[[nodiscard]] cv::Mat wordOfMarks(const ShadowMarks& marks, const MarkedSurface& surface, cv::Size picture,
                                  const ShadowMarkTuning& tuning = {});

/// The pixel of a picture of another size that holds a mark.
[[nodiscard]] cv::Point markedPixel(const ShadowMark& mark, cv::Size picture, cv::Size size);

}  // namespace swaplight
