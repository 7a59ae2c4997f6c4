#include "core/solve/solve_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"

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

/// JSON has no infinity.
Json finiteOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace

void SolveReport::summarize(const SolvedSet& set) {
  pixels = set.beta.pixelCount();
  residualMedian = medianOfPlane(set.quality.plane(kResidual), pixels);
  sigmaMedian = medianOfPlane(set.quality.plane(kSigma), pixels);
  for (size_t p = 0; p < pixels; ++p) {
    const int flags = int(set.quality.plane(kFlags)[p]);
    clipped += (flags & kClipped) != 0;
    tooDark += (flags & kTooDark) != 0;
    moved += (flags & kMoved) != 0;
    notFinite += (flags & kNotFinite) != 0;
    filled += (flags & kFilled) != 0;
  }
  const auto percent = [&](size_t count) {
    return 100.0 * double(count) / double(std::max<size_t>(pixels, 1));
  };
  message = fmt::format(
      "{} lights told apart in {:.2f} s ({}, {}). A light's part is known to {:.1f} % of the pixel "
      "(median).",
      set.lightCount(), seconds, model, solver, 100 * sigmaMedian);
  if (residualMedian > 3)
    message += fmt::format(
        " The pictures disagree with the light colours by {:.1f} times their noise: check the "
        "colours, and that nothing moved.",
        residualMedian);
  for (const std::string& color : estimated) message += " " + color + ".";
  double farthest = 0;
  for (const ShotShift& shift : shifts) farthest = std::max(farthest, double(std::hypot(shift.x, shift.y)));
  if (farthest > 0) message += fmt::format(" Shots aligned; the farthest lay {:.2f} pixels off.", farthest);
  if (clipped) message += fmt::format(" Clipped in a shot: {:.2f} % of the pixels.", percent(clipped));
  if (tooDark) message += fmt::format(" Too dark to tell: {:.2f} %.", percent(tooDark));
  if (moved) message += fmt::format(" Moved between shots: {:.2f} %.", percent(moved));
  if (notFinite)
    message += fmt::format(" Not a number, infinite or negative in a shot: {} pixels.", notFinite);
  for (const std::string& advice : conditioning.advice) message += " Note: " + advice + ".";
}

Json jsonFromConditioning(const Conditioning& conditioning) {
  Json channels = Json::array();
  for (size_t c = 0; c < 3; ++c)
    channels.push_back({{"channel", std::string(1, "RGB"[c])},
                        {"singular_values", conditioning.singularValues[c]},
                        {"condition", finiteOrNull(conditioning.condition[c])},
                        {"amplification", finiteOrNull(conditioning.amplification[c])}});
  return {{"channels", channels},
          {"matte_amplification", finiteOrNull(conditioning.matteAmplification)},
          {"advice", conditioning.advice}};
}

Json jsonFromSolveReport(const SolveReport& report) {
  Json refined = Json::array();
  Json shifts = Json::array();
  for (const ShotShift& shift : report.shifts)
    shifts.push_back(shift.found ? Json{shift.x, shift.y} : Json(nullptr));
  for (const Rgb& color : report.refinedColors) refined.push_back({color.r, color.g, color.b});
  return {{"message", report.message},
          {"model", report.model},
          {"solver", report.solver},
          {"noise",
           {{"read", report.noise.read},
            {"full_well", report.noise.fullWell},
            {"estimated", !report.noiseGiven}}},
          {"color_uncertainty", report.colorUncertainty},
          {"color_disagreement", report.colorDisagreement},
          {"color_change", report.colorChange},
          {"refined_colors", refined},
          {"estimated", report.estimated},
          {"shifts", shifts},
          {"conditioning", jsonFromConditioning(report.conditioning)},
          {"residual_median", report.residualMedian},
          {"sigma_median", report.sigmaMedian},
          {"pixels", report.pixels},
          {"clipped", report.clipped},
          {"too_dark", report.tooDark},
          {"moved", report.moved},
          {"not_finite", report.notFinite},
          {"filled", report.filled},
          {"seconds", report.seconds},
          {"warnings", report.warnings}};
}

}  // namespace swaplight
