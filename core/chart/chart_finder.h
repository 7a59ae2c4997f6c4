#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/chart/chart_corners.h"
#include "core/image/image.h"

namespace swaplight {

/// Looks for a Macbeth chart in a picture in linear light (R G B), by OpenCV's detector (module mcc; squares
/// that lie as a chart's do), in copies that are coded for a display: balanced, brighter, and without colour,
/// for charts under gels. What it finds counts where its patches look like a chart's (chartLikeness), and is
/// moved to where they are even (refinedCorners). Nothing where none is found. A few seconds. Throws Stopped.
[[nodiscard]] std::optional<ChartCorners> findChart(const Image& picture, float clipLevel,
                                                    const Progress& progress = {});

/// The corners in the order of ChartCorners: the arrangement that looks most like a chart. They may be told
/// in any order around it, and a fifth of a patch off. Throws InputError as readChart does, and where what
/// lies between them looks like none.
[[nodiscard]] ChartCorners orientedCorners(const Image& picture, float clipLevel,
                                           const ChartCorners& corners);

}  // namespace swaplight
