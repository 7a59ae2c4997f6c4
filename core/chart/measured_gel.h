#pragma once

#include "core/chart/chart_shot.h"

namespace swaplight {

/// What a gel lets through of each linear Rec.709 channel of white, by a chart in two photographs of one
/// lamp, one of them through the gel: the ratio of its lights, through the matrix of the other photograph
/// where it has one, exposures as the files state them. 0 where it is less. Throws InputError where only one
/// of them states its exposure.
[[nodiscard]] Rgb measuredGel(const ChartShot& through, const ChartShot& without);

/// log2 of how much more a photograph was exposed than another; 0 where neither says. Throws InputError where
/// one of them does.
[[nodiscard]] double exposureOver(const ChartShot& shot, const ChartShot& other);

}  // namespace swaplight
