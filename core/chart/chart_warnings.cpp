#include "core/chart/chart_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace swaplight {
namespace {

constexpr double kBadMean = 3, kBadMost = 10;  // CIEDE2000: raw files of real cameras leave 1 to 2, 3 to 6
constexpr double kUneven = .15;
constexpr double kGlare = 1.5;  // the black patch, over what it reflects

std::string namesOf(const ChartFit& fit, bool PatchFit::*which) {
  std::vector<std::string> names;
  for (size_t p = 0; p < kChartPatches; ++p)
    if (fit.patches[p].*which) names.emplace_back(chartPatchName(p));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// How many times as bright the black patch is as it should be; 0 where it was not seen.
double glareOf(const ChartFit& fit) {
  const PatchFit& black = fit.patches.back();
  if (black.clipped) return 0;
  return double(luminance(glm::max(black.color, Rgb(0))) / luminance(chartReflectances().back()));
}

}  // namespace

std::vector<std::string> chartWarnings(const ChartFit& fit) {
  std::vector<std::string> warnings;
  if (const std::string names = namesOf(fit, &PatchFit::clipped); !names.empty())
    warnings.push_back("patches are saturated or black and were not used: " + names +
                       "; expose the chart less");
  if (const std::string names = namesOf(fit, &PatchFit::outlier); !names.empty())
    warnings.push_back("patches do not fit the others (glare, a shadow, dirt) and were left out: " + names);
  if (!fit.matrix)
    warnings.emplace_back(
        "the light has next to nothing of a colour, so that no camera matrix can be told: photograph the "
        "chart in white light for it");
  else if (fit.meanDeltaE > kBadMean || fit.mostDeltaE > kBadMost)
    warnings.push_back(fmt::format(
        "the patches are CIEDE2000 {:.1f} off in the mean, {:.1f} at most: the light is far from white, the "
        "file does not hold light as its colour space says (a camera's JPEG: swaplight response), or there "
        "is glare",
        fit.meanDeltaE, fit.mostDeltaE));
  if (std::max(std::abs(fit.across), std::abs(fit.down)) > kUneven)
    warnings.push_back(fmt::format(
        "the light changes over the chart by {:+.0f} % to the right and {:+.0f} % downwards: it was "
        "taken off, but turn the chart to the light",
        100 * fit.across, 100 * fit.down));
  if (const double glare = glareOf(fit); glare > kGlare)
    warnings.push_back(fmt::format(
        "the black patch is {:.1f} times as bright as it should be: glare on the chart, or light in the lens",
        glare));
  return warnings;
}

}  // namespace swaplight
