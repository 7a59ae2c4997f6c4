#include "core/solve/causes/tone_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/cause_evidence.h"
#include "core/solve/causes/cause_fit.h"
#include "core/solve/causes/cause_slopes.h"

namespace swaplight {
namespace {

constexpr double kLowest = 1e-5, kHighest = 1;  // values that the correction is kept at
constexpr double kLeastSlope = .2;              // of log light over log value
constexpr double kFrom = .03, kTo = .6;         // the middle of the range

double stepOf(int levels) {
  return std::log(kHighest / kLowest) / (levels - 1);
}

void correctImage(const ToneCorrection& tone, Image& image) {
  for (int c = 0; c < 3; ++c)
    parallelRows(image.height(), 32, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        float* row = image.span().row(c, y);
        std::transform(row, row + image.width(), row, std::cref(tone));
      }
    });
}

/// The photographs as corrected so far, ready to be fitted to.
struct Corrected {
  CapturePixels pixels;
  CauseContext context;

  Corrected(const Capture& capture, const CapturePixels& photographs, const std::optional<SensorNoise>& told,
            const ToneCorrection& tone)
      : pixels(corrected(photographs, tone)), context(causeContext(capture, pixels, told)) {}
  Corrected(const Corrected&) = delete;  // the context refers to the pixels
  Corrected& operator=(const Corrected&) = delete;

 private:
  static CapturePixels corrected(const CapturePixels& photographs, const ToneCorrection& tone) {
    CapturePixels pixels = withoutShots(photographs);
    for (const Image& shot : photographs.shots) pixels.shots.push_back(shot.clone());
    correctTone(tone, pixels);
    return pixels;
  }
};

/// Ambient light taken for a curve doubles the error; colours that fit nearly as well are no such rival.
bool isLikelyTone(const Corrected& now, const CauseTuning& tuning) {
  const std::vector<Cause> likely = misfitCauses(now.context.estimator, now.context.signal, tuning).likely;
  const bool ambient = std::find(likely.begin(), likely.end(), Cause::Ambient) != likely.end();
  return !likely.empty() && likely.front() == Cause::Tone && !ambient;
}

/// One more fit; returns the change that it made. `bounced`: how large the ambient light is taken to be that
/// is fitted along with the curve; 0: none is.
double improve(const Corrected& now, double bounced, const CauseTuning& tuning, ToneCorrection& tone) {
  const std::vector<PixelMisfit> sample =
      misfitSample(now.context.estimator, now.context.signal, tuning.pixels, tuning);
  const MisfitRows rows = misfitRows(sample);
  const std::vector<CauseModel> models = causeModels(now.context.estimator, now.context.signal, sample);
  const auto modelOf = [&](Cause cause) -> const CauseModel& {
    return *std::ranges::find(models, cause, &CauseModel::cause);
  };
  const CauseModel& curve = modelOf(Cause::Tone);
  Eigen::MatrixXd slopes = visibleSlopes(curve, sample, rows);
  const Eigen::Index terms = slopes.cols();
  if (bounced > 0) {
    // All unknowns of a fit have one prior: so those of a smaller one have smaller slopes.
    const Eigen::MatrixXd light =
        visibleSlopes(modelOf(Cause::Ambient), sample, rows) * (bounced / curve.prior);
    slopes.conservativeResize(Eigen::NoChange, terms + light.cols());
    slopes.rightCols(light.cols()) = light;
  }
  const CauseFit fit = fitCause(rows, slopes, {0, int(sample.size())}, curve.prior, tuning);
  const Eigen::VectorXd unknowns = fit.unknowns.head(terms);
  std::vector<double> gain;
  for (const double light : tone.lights()) gain.push_back(toneGain(unknowns, light));
  return tone.takeOff(gain);
}

}  // namespace

ToneCorrection::ToneCorrection() {
  for (int j = 0; j < kLevels; ++j) m_logLight[size_t(j)] = std::log(kLowest) + j * stepOf(kLevels);
}

float ToneCorrection::operator()(float value) const {
  if (!(value > 0) || !std::isfinite(value)) return value;
  const double position = (std::log(double(value)) - std::log(kLowest)) / stepOf(kLevels);
  if (position <= 0) return float(double(value) / kLowest * std::exp(m_logLight.front()));
  if (position >= kLevels - 1) return float(double(value) / kHighest * std::exp(m_logLight.back()));
  const auto below = size_t(position);
  const double part = position - double(below);
  return float(std::exp((1 - part) * m_logLight[below] + part * m_logLight[below + 1]));
}

double ToneCorrection::takeOff(const std::vector<double>& gain) {
  double part = 1;
  for (int j = 1; j < kLevels; ++j) {
    const double rise = m_logLight[size_t(j)] - m_logLight[size_t(j - 1)];
    const double taken = gain[size_t(j)] - gain[size_t(j - 1)];
    const double least = std::min(kLeastSlope * stepOf(kLevels), rise);
    if (rise - taken < least && taken > 0) part = std::min(part, (rise - least) / taken);
  }
  double largest = 0;
  for (int j = 0; j < kLevels; ++j) {
    const double change = part * gain[size_t(j)];
    m_logLight[size_t(j)] -= change;
    if (j >= kLevels / 2) largest = std::max(largest, std::abs(change));
  }
  return largest;
}

ToneCorrection ToneCorrection::followedBy(const ToneCorrection& next) const {
  ToneCorrection both;
  for (size_t j = 0; j < size_t(kLevels); ++j)
    both.m_logLight[j] = std::log(double(next(float(std::exp(m_logLight[j])))));
  return both;
}

ToneCorrection ToneCorrection::halfWayTo(const ToneCorrection& other) const {
  ToneCorrection middle;
  for (size_t j = 0; j < size_t(kLevels); ++j)
    middle.m_logLight[j] = (m_logLight[j] + other.m_logLight[j]) / 2;
  return middle;
}

std::vector<double> ToneCorrection::lights() const {
  std::vector<double> lights;
  for (const double log : m_logLight) lights.push_back(std::exp(log));
  return lights;
}

double ToneCorrection::exponent() const {
  return std::log(kTo / kFrom) / std::log(double((*this)(float(kTo))) / double((*this)(float(kFrom))));
}

std::vector<std::array<float, 2>> ToneCorrection::curve() const {
  std::vector<std::array<float, 2>> curve;
  for (const float value : {.01F, .02F, .05F, .1F, .2F, .4F, .7F, 1.0F})
    curve.push_back({value, (*this)(value)});
  return curve;
}

std::optional<FoundTone> findToneCorrection(const Capture& capture, const CapturePixels& photographs,
                                            const std::optional<SensorNoise>& noise, const Progress& progress,
                                            const CauseTuning& tuning) {
  for (const Shot& shot : capture.shots)
    for (const auto& color : shot.lightColors)
      if (!color)
        throw InputError(
            "{}: a light colour is unknown, so that no tone curve can be told from the photographs; tell the "
            "colour, or do not ask for one (--tone auto)",
            capture.calledName());
  const std::optional<SensorNoise> told = toldNoise(capture, noise);
  ToneCorrection with, without;
  {
    const Corrected declared(capture, photographs, told, {});
    if (!isLikelyTone(declared, tuning)) return std::nullopt;
    improve(declared, tuning.bounced, tuning, with);
    improve(declared, 0, tuning, without);
  }
  const auto refine = [&](double bounced, ToneCorrection& tone) {
    for (int round = 1; round < ToneCorrection::kMostRounds; ++round) {
      progress.stopIfAsked();
      const Corrected now(capture, photographs, told, tone);
      if (improve(now, bounced, tuning, tone) < ToneCorrection::kSettled) break;
    }
  };
  refine(tuning.bounced, with);
  refine(0, without);
  const bool steady = std::abs(with.exponent() - without.exponent()) < tuning.steadyExponent;
  return FoundTone{steady ? with.halfWayTo(without) : with, steady};
}

void correctTone(const ToneCorrection& tone, CapturePixels& photographs) {
  for (Image& shot : photographs.shots) correctImage(tone, shot);
  if (photographs.ambient) correctImage(tone, *photographs.ambient);
  for (float& clip : photographs.clipLevel) clip = tone(clip);
}

void reportTone(const FoundTone& tone, SolveReport& report) {
  const ToneCorrection& curve = tone.correction;
  report.tone = TakenTone{curve.exponent(), curve.curve()};
  report.message += fmt::format(
      " A tone curve that was not told has been taken off the photographs: light to the power of about "
      "{:.2f}.",
      curve.exponent());
  if (!tone.steady)
    report.warnings.emplace_back(
        "the tone curve that was taken off is not sure: some of it may be bounced or ambient light; compare "
        "with a solve that leaves it (--tone declared)");
}

}  // namespace swaplight
