#include "core/solve/calibration/swapped_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/solve/calibration/swap_shares.h"
#include "core/solve/calibration/swapped_evening.h"

namespace swaplight {
namespace {

/// The colour at `times` the line's contrast.
Rgb colorAt(const SwappedColorLine& line, float times) {
  const Rgb d = times * line.direction;
  return line.known * (Rgb(1) - d) / (Rgb(1) + d);
}

/// RMS of the logarithms.
double distanceFromWhite(const Rgb& color) {
  double square = 0;
  for (int c = 0; c < 3; ++c) square += std::pow(std::log(std::max(double(color[c]), 1e-6)), 2);
  return std::sqrt(square / 3);
}

/// Where a line comes nearest to white of full level, as far as its scale may be wrong.
struct BareLamp {
  float times = 1;             ///< the line's contrast
  double distance = INFINITY;  ///< of the logarithms, RMS
};

BareLamp bareLampOn(const SwappedColorLine& line, const SwappedColorTuning& tuning) {
  constexpr int kSteps = 200;
  const float widest =
      std::max({std::abs(line.direction.r), std::abs(line.direction.g), std::abs(line.direction.b)});
  const float slack = std::min(float(tuning.scaleError) / widest, .35F);
  BareLamp best;
  for (int step = 0; step <= kSteps; ++step) {
    const float times = 1 - slack + 2 * slack * float(step) / kSteps;
    if (times > line.most) break;
    if (const double distance = distanceFromWhite(colorAt(line, times)); distance < best.distance)
      best = {times, distance};
  }
  return best;
}

/// The line with the place of a lamp without a gel as its likely one.
SwappedColorLine withBareLamp(SwappedColorLine line, float times) {
  line.bareLamp = true;
  if (times < 1) {  // nearer to the known gel than any pixel seemed to allow
    line.direction *= times;
    line.most /= times;
  } else if (line.most > 1) {
    line.likely = std::min((times - 1) / (line.most - 1), 1.0F);
  }
  return line;
}

/// Which of the two directions? A line is thin, and hardly one of all gels lies on it by chance: where white
/// of full level does, the lamp had no gel, which is the commonest there is. Else the colour that a gel can
/// have, which lets through no more than all light; where both can, the one under which the set is nearer to
/// grey.
SwappedColorLine likelier(const SwappedColorLine& line, const Rgb& light, const SwappedColorTuning& tuning) {
  constexpr float kMost = 1.05F;  // of full light: a gel's number is a little off
  const SwappedColorLine other = line.opposite();
  const BareLamp here = bareLampOn(line, tuning), there = bareLampOn(other, tuning);
  // From a known gel that is nearly white itself both lines come by.
  const bool gelled = distanceFromWhite(line.known) > 2 * tuning.bareLamp;
  if (gelled && std::min(here.distance, there.distance) < tuning.bareLamp)
    return here.distance <= there.distance ? withBareLamp(line, here.times)
                                           : withBareLamp(other, there.times);
  const auto possible = [](const Rgb& color) { return std::max({color.r, color.g, color.b}) <= kMost; };
  if (possible(line.at(0)) != possible(other.at(0))) return possible(line.at(0)) ? line : other;
  return line.tintOf(0, light) <= other.tintOf(0, light) ? line : other;
}

}  // namespace

SwappedColorLine SwappedColorLine::opposite() const {
  return {known, -direction, most, likely};
}

Rgb SwappedColorLine::at(float position) const {
  return colorAt(*this, 1 + std::clamp(position, 0.0F, 1.0F) * (most - 1));
}

double SwappedColorLine::tintOf(float position, const Rgb& light) const {
  const Rgb reflectance = light / (known + at(position));
  const double mean = std::log(std::max(double(reflectance.r) * reflectance.g * reflectance.b, 1e-30)) / 3;
  double spread = 0;
  for (int c = 0; c < 3; ++c) spread += std::pow(std::log(std::max(double(reflectance[c]), 1e-10)) - mean, 2);
  return spread;
}

SwappedColorLine swappedColorLine(const Capture& capture, const SwappedColor& swapped,
                                  const ShotSignal& signal, const NoiseModel& noise,
                                  const SwappedColorTuning& tuning) {
  const Evening evening(capture, swapped);
  const std::vector<SwapContrast> contrasts =
      swapContrasts(signal, swapped, capture.shotCount(), evening, noise, tuning);
  if (contrasts.size() < size_t(tuning.minGroups))
    throw InputError(
        "an unknown colour cannot be estimated: hardly a pixel is bright enough and not clipped in both "
        "photographs; tell the colour");
  const SwapShares fit = swapShares(contrasts, tuning);
  SwappedColorLine line;
  line.known = evening.known;
  const double widest = fit.direction.cwiseAbs().maxCoeff();
  const double scale = std::min(swapScale(contrasts, fit, tuning), tuning.farthest / widest);
  if (!(scale * widest > tuning.minContrast))
    throw InputError(
        "an unknown colour cannot be estimated: photographs {} and {} do not differ; did the lamps exchange "
        "their gels?",
        swapped.shots[0] + 1, swapped.shots[1] + 1);
  for (int c = 0; c < 3; ++c) line.direction[c] = float(scale * fit.direction[c]);
  line.most = float(tuning.farthest / (scale * widest));
  const std::vector<Rgb> mean = signal.meanSignal();
  return likelier(
      line,
      evening.factor[0] * mean[size_t(swapped.shots[0])] + evening.factor[1] * mean[size_t(swapped.shots[1])],
      tuning);
}

}  // namespace swaplight
