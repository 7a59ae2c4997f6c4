#include "core/solve/causes/linearity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/json.h"
#include "core/solve/causes/additivity_sample.h"
#include "core/solve/causes/cause_evidence.h"
#include "core/solve/causes/cause_slopes.h"
#include "core/solve/causes/tone_correction.h"
#include "core/solve/model/crossed_shots.h"
#include "core/solve/model/unknown_color.h"

namespace swaplight {
namespace {

constexpr const char* kWouldTell = "Photograph brackets, or each lamp alone and all together";
constexpr const char* kLooking = "looking whether the photographs hold light";

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
    progress.update(float(round) / ToneCorrection::kMostRounds, kLooking);
    const AdditivitySample sample = additivitySample(context, exposure, tone, tuning.pixels, tuning);
    if (int(sample.pixels.size()) < tuning.fewestPixels) break;
    const Eigen::VectorXd unknowns = fittedTone(context, sample.pixels, tuning);
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
  progress.update(0, kLooking);
  const CauseContext context = causeContext(capture, photographs, toldNoise(capture, {}));
  std::vector<double> exposure;
  for (const Shot& shot : capture.shots) exposure.push_back(std::exp2(double(shot.exposureStops)));
  const CauseContext apart = withUnknownsApart(context, capture, exposure);
  if (!isUnknown(capture, true)) {
    const AdditivitySample sums = additivitySample(apart, exposure, {}, tuning.pixels, tuning);
    evidence.ambientProof = sums.ambientProof;
    evidence.additivity = toneEvidence(context, sums.pixels, progress.part(.1F, .4F), tuning);
    // Six photographs of three gels, swapped: lamps that flicker by 2 % look like a power of 2 there.
    if (evidence.additivity && !(evidence.additivity->levelError < tuning.mostLevelError))
      evidence.additivity.reset();
  }
  if (!isUnknown(capture, false)) {
    progress.update(.4F, kLooking);
    evidence.causes = misfitCauses(context.estimator, context.signal, tuning);
    const auto sample = misfitSample(context.estimator, context.signal, tuning.pixels, tuning);
    evidence.matte = toneEvidence(context, sample, progress.part(.5F, .7F), tuning);
  }
  progress.update(.7F, kLooking);
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
