#include "core/solve/causes/linearity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/json.h"
#include "core/base/quantile.h"
#include "core/solve/causes/additivity_sample.h"
#include "core/solve/causes/cause_evidence.h"
#include "core/solve/causes/cause_fit.h"
#include "core/solve/causes/cause_slopes.h"
#include "core/solve/causes/tone_correction.h"
#include "core/solve/model/crossed_shots.h"
#include "core/solve/model/pixel_run.h"
#include "core/solve/model/unknown_color.h"

namespace swaplight {
namespace {

constexpr const char* kWouldTell = "Photograph brackets, or each lamp alone and all together";
constexpr const char* kWhat = "looking whether the photographs hold light";
constexpr int kParts = 4;            // across and down, that are left out in turns
constexpr size_t kFewestParts = 8;   // in fewer a standard error is none
constexpr int kLevels = 33;          // at which a curve is looked at
constexpr double kLevelError = .02;  // of a photograph: lamps flicker, shutters are not exact
constexpr double kMostLevelErrors = 3;

/// A sample, its part of the picture after part, and what a tone curve does to it.
struct ToneRows {
  MisfitRows rows;
  Eigen::MatrixXd slopes;
  Eigen::MatrixXd others;  ///< what else may be wrong, and must not be taken for a curve
  std::vector<PixelSpan> parts;
  double prior = 1;
};

/// What a wrong level of each photograph does to the rows of a sample, in units in which `prior` is
/// kLevelError.
Eigen::MatrixXd levelSlopes(const std::vector<PixelMisfit>& sample, const MisfitRows& rows, double prior) {
  const Eigen::Index shots = sample.empty() ? 0 : sample.front().predicted.size() / 3;
  Eigen::MatrixXd slopes(rows.residual.size(), shots);
  for (size_t p = 0; p < sample.size(); ++p) {
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(3 * shots, shots);
    for (Eigen::Index row = 0; row < 3 * shots; ++row)
      change(row, row / 3) = kLevelError / prior * sample[p].predicted[row];
    slopes.middleRows(rows.first[p], sample[p].residual.size()) = sample[p].visible(change);
  }
  return slopes;
}

ToneRows toneRows(const CauseContext& context, std::vector<PixelMisfit> sample) {
  const CapturePixels& pixels = context.signal.pixels();
  const auto partOf = [&](const PixelMisfit& pixel) {
    return pixel.y * kParts / pixels.height() * kParts + pixel.x * kParts / pixels.width();
  };
  std::stable_sort(sample.begin(), sample.end(),
                   [&](const PixelMisfit& a, const PixelMisfit& b) { return partOf(a) < partOf(b); });
  ToneRows tone;
  tone.rows = misfitRows(sample);
  for (int p = 0; p < int(sample.size()); ++p) {
    if (tone.parts.empty() || partOf(sample[size_t(p)]) != partOf(sample[size_t(p - 1)]))
      tone.parts.push_back({p, p});
    tone.parts.back().end = p + 1;
  }
  for (const CauseModel& model : causeModels(context.estimator, context.signal, sample))
    if (model.cause == Cause::Tone) {
      tone.slopes = visibleSlopes(model, sample, tone.rows);
      tone.prior = model.prior;
      tone.others = levelSlopes(sample, tone.rows, model.prior);
    }
  return tone;
}

/// All rows but a part's.
ToneRows withoutPart(const ToneRows& all, const PixelSpan& part) {
  const Eigen::Index begin = all.rows.first[size_t(part.begin)], end = all.rows.first[size_t(part.end)];
  const Eigen::Index after = all.rows.residual.size() - end;
  ToneRows rest;
  rest.prior = all.prior;
  rest.rows.residual.resize(begin + after);
  rest.rows.residual << all.rows.residual.head(begin), all.rows.residual.tail(after);
  rest.slopes.resize(begin + after, all.slopes.cols());
  rest.slopes << all.slopes.topRows(begin), all.slopes.bottomRows(after);
  rest.others.resize(begin + after, all.others.cols());
  rest.others << all.others.topRows(begin), all.others.bottomRows(after);
  rest.rows.first.assign(all.rows.first.begin(), all.rows.first.begin() + part.begin + 1);
  for (size_t p = size_t(part.end) + 1; p < all.rows.first.size(); ++p)
    rest.rows.first.push_back(all.rows.first[p] - (end - begin));
  return rest;
}

/// With the first `terms` of the curve; `unknowns` are those.
CauseFit fitTerms(const ToneRows& tone, Eigen::Index terms, const CauseTuning& tuning) {
  Eigen::MatrixXd slopes(tone.slopes.rows(), terms + tone.others.cols());
  slopes << tone.slopes.leftCols(terms), tone.others;
  CauseFit fit = fitCause(tone.rows, slopes, {0, int(tone.rows.first.size()) - 1}, tone.prior, tuning);
  fit.unknowns.conservativeResize(terms);
  return fit;
}

/// Without a curve: what levels leave, unless they would have to be more wrong than levels are.
double squaredScaleWithout(const ToneRows& tone, const CauseTuning& tuning) {
  const PixelSpan all{0, int(tone.rows.first.size()) - 1};
  const CauseFit levels = fitCause(tone.rows, tone.others, all, tone.prior, tuning);
  const double most = levels.unknowns.cwiseAbs().maxCoeff() / tone.prior;
  if (most <= kMostLevelErrors) return levels.squaredScale;
  return fitCause(tone.rows, tone.others.leftCols(0), all, tone.prior, tuning).squaredScale;
}

/// The power of light that a level of every photograph off by kLevelError looks like, RMS.
double exponentOfLevels(const ToneRows& tone) {
  const Eigen::VectorXd exponent = tone.slopes.col(0);
  const double squares = exponent.squaredNorm();
  if (!(squares > 0)) return INFINITY;
  return tone.prior * (tone.others.transpose() * exponent).norm() / squares;
}

/// The values that most of a sample has, evenly in the logarithm.
std::vector<double> levelsOf(const std::vector<PixelMisfit>& sample) {
  std::vector<double> values;
  for (const PixelMisfit& pixel : sample)
    for (const double value : pixel.predicted) values.push_back(value);
  const double low = std::max(quantile(std::span(values), .1), 1e-4);
  const double high = std::max(quantile(std::span(values), .9), 1.1 * low);
  std::vector<double> levels;
  for (int j = 0; j < kLevels; ++j) levels.push_back(low * std::pow(high / low, double(j) / (kLevels - 1)));
  return levels;
}

/// The logarithm of what a curve makes of light, up to exposure.
std::vector<double> departures(const Eigen::VectorXd& unknowns, const std::vector<double>& levels) {
  std::vector<double> gain;
  double mean = 0;
  for (const double level : levels) {
    gain.push_back(toneGain(unknowns, level));
    mean += gain.back() / double(levels.size());
  }
  for (double& one : gain) one -= mean;
  return gain;
}

/// Of what is estimated with parts left out in turns.
double jackknifeError(const std::vector<double>& estimates) {
  double mean = 0, squares = 0;
  const auto count = double(estimates.size());
  for (const double one : estimates) mean += one / count;
  for (const double one : estimates) squares += (one - mean) * (one - mean);
  return std::sqrt(squares * (count - 1) / count);
}

/// How far a power of light is open where the sample cannot show one: one white lamp a photograph is matte
/// again under any power. Parts of the picture agree in that, so that leaving them out does not show it.
double hiddenExponent(const ToneRows& tone, double squaredScale) {
  return 1 / std::sqrt(tone.slopes.col(0).squaredNorm() / squaredScale + 1 / (tone.prior * tone.prior));
}

/// Nothing where too small a part of the picture is in the sample.
std::optional<ToneEvidence> evidenceIn(const CauseContext& context, const std::vector<PixelMisfit>& sample,
                                       const Progress& progress, const CauseTuning& tuning) {
  if (int(sample.size()) < tuning.fewestPixels) return std::nullopt;
  const ToneRows tone = toneRows(context, sample);
  if (tone.parts.size() < kFewestParts) return std::nullopt;
  const Eigen::Index terms = tone.slopes.cols();
  const CauseFit curve = fitTerms(tone, terms, tuning);
  const std::vector<double> levels = levelsOf(sample);
  const std::vector<double> gain = departures(curve.unknowns, levels);
  const auto most = std::max_element(gain.begin(), gain.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
  std::vector<double> exponents, gains;
  for (const PixelSpan& part : tone.parts) {
    progress.update(float(exponents.size()) / float(tone.parts.size()), kWhat);
    const ToneRows rest = withoutPart(tone, part);
    exponents.push_back(fitTerms(rest, 1, tuning).unknowns[0]);
    gains.push_back(departures(fitTerms(rest, terms, tuning).unknowns, levels)[size_t(most - gain.begin())]);
  }
  ToneEvidence evidence;
  const double none = squaredScaleWithout(tone, tuning);
  const double hidden = hiddenExponent(tone, none);
  evidence.exponent = 1 + fitTerms(tone, 1, tuning).unknowns[0];
  evidence.exponentError = std::hypot(jackknifeError(exponents), hidden);
  evidence.departure = std::abs(*most);
  evidence.departureError =
      std::hypot(jackknifeError(gains), hidden * .5 * std::log(levels.back() / levels.front()));
  evidence.explained = std::clamp(1 - curve.squaredScale / none, 0.0, 1.0);
  evidence.misfit = std::sqrt(none);
  evidence.levelError = exponentOfLevels(tone);
  return evidence;
}

bool isCurved(const ToneEvidence& one, const CauseTuning& tuning) {
  return one.departure > tuning.leastDeparture && one.departure > tuning.sure * one.departureError &&
         one.explained > tuning.tone.explained;
}

/// The departure that it may have.
double mostDeparture(const ToneEvidence& one) {
  return one.departure + 2 * one.departureError;
}

/// Gauss-Newton, as in findToneCorrection, on the sample alone.
ToneCorrection toneByAdditivity(const CauseContext& context, const std::vector<double>& exposure,
                                const Progress& progress, const CauseTuning& tuning) {
  ToneCorrection tone;
  for (int round = 0; round < ToneCorrection::kMostRounds; ++round) {
    progress.update(float(round) / ToneCorrection::kMostRounds, kWhat);
    const AdditivitySample sample = additivitySample(context, exposure, tone, tuning.pixels, tuning);
    if (int(sample.pixels.size()) < tuning.fewestPixels) break;
    const ToneRows rows = toneRows(context, sample.pixels);
    const Eigen::VectorXd unknowns = fitTerms(rows, rows.slopes.cols(), tuning).unknowns;
    std::vector<double> gain;
    for (const double light : tone.lights()) gain.push_back(toneGain(unknowns, light));
    if (tone.takeOff(gain) < ToneCorrection::kSettled) break;
  }
  return tone;
}

bool isUnknown(const Capture& capture, bool named) {
  for (const Shot& shot : capture.shots)
    for (size_t i = 0; i < shot.lightColors.size(); ++i)
      if (!shot.lightColors[i] && (!named || shot.colorName(i).empty())) return true;
  return false;
}

/// With a colour of its own for each unknown one: which gels are the same is all that sums ask, and an
/// unknown one is the same as no other.
CauseContext withUnknownsApart(CauseContext context, const Capture& capture,
                               const std::vector<double>& exposure) {
  const std::vector<UnknownColor> unknown = unknownColorsOf(capture);
  const auto lights = size_t(capture.lightCount());
  for (size_t j = 0; j < unknown.size(); ++j)
    for (const int entry : unknown[j].entries) {
      const auto place = size_t(entry);
      context.estimator.lighting.color(int(place / lights), int(place % lights)) =
          Rgb(1e3F * float(j + 2)) * float(exposure[place / lights]);
    }
  return context;
}

bool has(const MisfitCauses& causes, Cause cause) {
  return std::find(causes.likely.begin(), causes.likely.end(), cause) != causes.likely.end();
}

std::string percent(double logarithm) {
  return fmt::format("{:.0f} %", 100 * std::expm1(logarithm));
}

void answer(LinearityEvidence& evidence, LinearityEvidence::Answer what, const std::string& finding) {
  evidence.answer = what;
  evidence.finding = evidence.words = finding;
}

void answerCurved(LinearityEvidence& evidence, const char* how, double exponent) {
  answer(evidence, LinearityEvidence::Answer::Curved,
         fmt::format("no: they do not hold light as their colour space says, but light to the power of about "
                     "{:.2f} in the middle of the range ({})",
                     exponent, how));
  evidence.words +=
      ". Photograph raw, measure the camera (swaplight response), or let the solve take the curve off "
      "(--tone "
      "auto)";
}

/// What adding photographs up says; whether it settles the matter.
bool settledByAdditivity(const CauseContext& context, const std::vector<double>& exposure,
                         const Progress& progress, const CauseTuning& tuning, LinearityEvidence& evidence) {
  using Answer = LinearityEvidence::Answer;
  if (!evidence.additivity) return false;
  const ToneEvidence& sums = *evidence.additivity;
  const bool mayBeAmbient =
      !evidence.ambientProof && (evidence.causes.all.empty() || has(evidence.causes, Cause::Ambient));
  if (isCurved(sums, tuning)) {
    if (mayBeAmbient) {
      answer(
          evidence, Answer::Unknown,
          "it cannot be told: the photographs do not add up, which ambient light or a tone curve may be the "
          "reason of; take a picture with all lamps off");
      return true;
    }
    const ToneCorrection tone = toneByAdditivity(context, exposure, progress, tuning);
    evidence.curve = tone.curve();
    answerCurved(evidence, "photographs do not add up to others", tone.exponent());
    return true;
  }
  if (mostDeparture(sums) > tuning.additiveWithin) return false;
  answer(evidence, Answer::Linear,
         fmt::format("yes: photographs add up to others, to {} of the light from dark to bright",
                     percent(mostDeparture(sums))));
  return true;
}

/// What matte surfaces say.
void answerByMatte(const Capture& capture, const CapturePixels& photographs, const CauseTuning& tuning,
                   LinearityEvidence& evidence) {
  using Answer = LinearityEvidence::Answer;
  const MisfitCauses& causes = evidence.causes;
  if (causes.is(Cause::Tone)) {
    const auto tone = findToneCorrection(capture, photographs, {}, {}, tuning);
    if (tone) evidence.curve = tone->correction.curve();
    const double exponent = tone ? tone->correction.exponent() : evidence.matte->exponent;
    if (tone && !tone->steady)
      return answer(
          evidence, Answer::Unknown,
          fmt::format(
              "it cannot be told: a curve is likeliest, light to the power of about {:.2f} in the middle of "
              "the range, but some of it may be bounced or ambient light. {}",
              exponent, kWouldTell));
    return answerCurved(evidence, "matte surfaces would look otherwise under these colours", exponent);
  }
  if (!causes.likely.empty())
    return answer(evidence, Answer::Unknown, "it cannot be told: " + wordsFor(causes));
  if (mostDeparture(*evidence.matte) < tuning.matteWithin)
    return answer(evidence, Answer::Linear,
                  fmt::format("yes, as far as surfaces are matte: to {} of the light from dark to bright",
                              percent(mostDeparture(*evidence.matte))));
  answer(evidence, Answer::Unknown,
         fmt::format(
             "it cannot be told: matte surfaces show a curve of {} from dark to bright, as gloss and bounced "
             "light do, too. {}",
             mostDeparture(*evidence.matte) > 1 ? "more than 100 %"
                                                : "at most " + percent(mostDeparture(*evidence.matte)),
             kWouldTell));
}

}  // namespace

LinearityEvidence linearityOf(const Capture& capture, const CapturePixels& photographs,
                              const Progress& progress, const CauseTuning& tuning) {
  using Answer = LinearityEvidence::Answer;
  // The same light through another filter would look like a curve: those without highlights are asked.
  if (isPartlyCrossed(capture))
    return linearityOf(shotsOf(capture, true), copiedShots(capture, true, photographs), progress, tuning);
  LinearityEvidence evidence;
  if (capture.shotCount() > kMaxShots || capture.lightCount() > kMaxLights) {
    answer(evidence, Answer::Unknown,
           fmt::format("it cannot be told: of more than {} photographs or {} lights", kMaxShots, kMaxLights));
    return evidence;
  }
  progress.update(0, kWhat);
  const CauseContext context = causeContext(capture, photographs, toldNoise(capture, {}));
  std::vector<double> exposure;
  for (const Shot& shot : capture.shots) exposure.push_back(std::exp2(double(shot.exposureStops)));
  const CauseContext apart = withUnknownsApart(context, capture, exposure);
  if (!isUnknown(capture, true)) {
    const AdditivitySample sums = additivitySample(apart, exposure, {}, tuning.pixels, tuning);
    evidence.ambientProof = sums.ambientProof;
    evidence.additivity = evidenceIn(context, sums.pixels, progress.part(.1F, .4F), tuning);
    // Six photographs of three gels, swapped: lamps that flicker by 2 % look like a power of 2 there.
    if (evidence.additivity && !(evidence.additivity->levelError < tuning.mostLevelError))
      evidence.additivity.reset();
  }
  if (!isUnknown(capture, false)) {
    progress.update(.4F, kWhat);
    evidence.causes = misfitCauses(context.estimator, context.signal, tuning);
    const auto sample = misfitSample(context.estimator, context.signal, tuning.pixels, tuning);
    evidence.matte = evidenceIn(context, sample, progress.part(.5F, .7F), tuning);
  }
  progress.update(.7F, kWhat);
  if (settledByAdditivity(apart, exposure, progress.part(.7F, 1), tuning, evidence)) return evidence;
  if (evidence.matte)
    answerByMatte(capture, photographs, tuning, evidence);
  else
    answer(evidence, Answer::Unknown,
           isUnknown(capture, false)
               ? std::string("it cannot be told: a light's colour is unknown. Tell it, or photograph "
                             "brackets, or each lamp alone and all together")
               : fmt::format("it cannot be told: no photograph follows from the others. {}", kWouldTell));
  return evidence;
}

Json jsonFromLinearity(const LinearityEvidence& evidence) {
  const auto tone = [](const std::optional<ToneEvidence>& one) -> Json {
    if (!one) return nullptr;
    return {{"exponent", one->exponent},     {"exponent_error", one->exponentError},
            {"departure", one->departure},   {"departure_error", one->departureError},
            {"explained", one->explained},   {"misfit", one->misfit},
            {"level_error", one->levelError}};
  };
  Json linear = nullptr;
  if (evidence.answer != LinearityEvidence::Answer::Unknown)
    linear = evidence.answer == LinearityEvidence::Answer::Linear;
  Json curve = Json::array();
  for (const auto& [value, light] : evidence.curve) curve.push_back(Json::array({value, light}));
  return {{"linear", linear},
          {"words", evidence.words},
          {"additivity", tone(evidence.additivity)},
          {"ambient_proof", evidence.ambientProof},
          {"matte", tone(evidence.matte)},
          {"misfit_causes", jsonFromMisfitCauses(evidence.causes)},
          {"curve", curve}};
}

}  // namespace swaplight
