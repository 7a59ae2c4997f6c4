#include "core/solve/report_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/base/quantile.h"
#include "core/solve/registration/align_shots.h"

namespace swaplight {
namespace {

double medianOfPlane(const float* plane, size_t count) {
  // A sample says it as well, and costs nothing at 8 megapixels.
  std::vector<float> sample;
  const size_t step = std::max<size_t>(1, count / 100000);
  for (size_t p = 0; p < count; p += step) sample.push_back(plane[p]);
  if (sample.empty()) return 0;
  return median(std::span(sample));
}

/// What registering has found and moved.
std::string alignedWords(const std::vector<ShotShift>& shifts, int width, int height) {
  const float farthest = farthestMove(shifts, width, height);
  if (farthest == 0) return "";
  const bool turned =
      std::any_of(shifts.begin(), shifts.end(), [](const ShotShift& s) { return s.isTurned(); });
  return fmt::format(" Photographs aligned; the farthest moved by {:.2f} pixels{}.", farthest,
                     turned ? " at a corner, turned or zoomed" : "");
}

/// Of a set without any, an error relative to it is infinite.
bool hasLight(const SolvedSet& set) {
  return std::any_of(set.contributions.begin(), set.contributions.end(), [](const Image& contribution) {
    for (int c = 0; c < contribution.channelCount(); ++c)
      if (std::any_of(contribution.plane(c), contribution.plane(c) + contribution.pixelCount(),
                      [](float value) { return value > 0; }))
        return true;
    return false;
  });
}

}  // namespace

void summarize(const SolvedSet& set, SolveReport& report) {
  report.pixels = set.beta.pixelCount();
  report.residualMedian = medianOfPlane(set.quality.plane(kResidual), report.pixels);
  report.sigmaMedian = medianOfPlane(set.quality.plane(kSigma), report.pixels);
  if (!hasLight(set)) report.sigmaMedian = std::numeric_limits<double>::infinity();
  for (size_t p = 0; p < report.pixels; ++p) {
    const int flags = int(set.quality.plane(kFlags)[p]);
    report.clipped += (flags & kClipped) != 0;
    report.tooDark += (flags & kTooDark) != 0;
    report.moved += (flags & kMoved) != 0;
    report.notFinite += (flags & kNotFinite) != 0;
    report.filled += (flags & kFilled) != 0;
  }
  const auto percent = [&](size_t count) {
    return 100.0 * double(count) / double(std::max<size_t>(report.pixels, 1));
  };
  report.message =
      fmt::format("{} lights separated ({}, {}). ", set.lightCount(), report.model, report.solver);
  report.message += std::isfinite(report.sigmaMedian)
                        ? fmt::format("Contributions are known to {:.1f} % of the pixel (median).",
                                      100 * report.sigmaMedian)
                    : report.lost == report.pixels ? "No pixel is known."
                                                   : "The photographs hold no light.";
  if (report.residualMedian > 3)
    report.message += fmt::format(
        " The photographs disagree with the light colours by {:.1f} times their noise: check the colours, "
        "and that nothing moved.",
        report.residualMedian);
  for (const std::string& color : report.estimated) report.message += " " + color + ".";
  if (!report.shifts.empty())
    report.message += alignedWords(report.shifts, set.beta.width(), set.beta.height());
  if (report.clipped)
    report.message +=
        fmt::format(" Clipped in a photograph: {:.2f} % of the pixels.", percent(report.clipped));
  if (report.tooDark) report.message += fmt::format(" Too dark: {:.2f} %.", percent(report.tooDark));
  if (report.moved)
    report.message += fmt::format(" Moved between photographs: {:.2f} %.", percent(report.moved));
  if (report.notFinite)
    report.message +=
        fmt::format(" Not a number, infinite or negative in a photograph: {} pixels.", report.notFinite);
  for (const std::string& advice : report.conditioning.advice) report.message += " Note: " + advice + ".";
}

}  // namespace swaplight
