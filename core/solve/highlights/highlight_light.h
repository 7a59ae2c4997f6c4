#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// Each light's highlight: one R G B a light, >= 0.
struct HighlightLight {
  std::vector<Image> lights;
  double part = 0;               ///< of the picture in which some surely are, 0..1
  std::vector<uint8_t> clipped;  ///< a byte a pixel: 1 where a photograph is saturated, and they may be more
};

/// Each light's highlight, told by what photographs have beyond a set that is matte. `matte`: the same set
/// without highlights, solved (through crossed polarisers), in the photographs' scale; `capture`: what the
/// photographs are, ambient light included.
///
/// A highlight has its lamp's own colour (Shafer 1985), so that one number a light, at least 0, is fitted to
/// a pixel's channels in all photographs; saturated values count only where the others do not tell the
/// lights apart. What may be noise is taken off: s (1 - (1.5 sigma)^2 / <s^2>), <> the mean of 3 x 3 pixels,
/// sigma from the sensor's noise, the matte set's own and one per cent of its light. None where the matte set
/// is broken or has moved.
///
/// Throws InputError where the photographs' colours do not tell the lights' highlights apart, Stopped.
[[nodiscard]] HighlightLight highlightLight(const Capture& capture, const CapturePixels& photographs,
                                            const SolvedSet& matte, const Progress& progress = {});

/// Takes the highlights out of the photographs; saturated values become what the matte set would have shown.
/// Broken ones stay.
void takeHighlights(const Capture& capture, const std::vector<Image>& highlights, const SolvedSet& matte,
                    CapturePixels& photographs);

}  // namespace swaplight
