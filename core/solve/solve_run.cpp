#include "core/solve/solve_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/image/finite_image.h"
#include "core/set/fill.h"
#include "core/solve/auto/auto_solve.h"
#include "core/solve/auto/clipped_light.h"
#include "core/solve/auto/local_evidence.h"
#include "core/solve/calibration/ambient_light.h"
#include "core/solve/calibration/color_evidence.h"
#include "core/solve/calibration/color_fit.h"
#include "core/solve/calibration/noise_calibration.h"
#include "core/solve/calibration/residual_noise.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/cause_evidence.h"
#include "core/solve/causes/shift_fit.h"
#include "core/solve/clipped_bounds.h"
#include "core/solve/denoise.h"
#include "core/solve/pixel_flags.h"
#include "core/solve/pixelwise.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_pixels.h"
#include "core/solve/registration/moved_shots.h"
#include "core/solve/report_summary.h"

namespace swaplight {
namespace {

SolvedSet emptySet(const Capture& capture, const CapturePixels& pixels) {
  SolvedSet set;
  set.capture = capture;
  ImageSpec spec = pixels.shots.front().spec();
  for (int i = 0; i < capture.lightCount(); ++i) set.contributions.emplace_back(spec);
  spec.channels = {"residual", "sigma", "flags", "model"};
  spec.colorSpace = "data";
  set.quality = Image(spec, 0);
  spec.channels.clear();
  for (const Light& light : capture.lights) spec.channels.push_back("beta." + light.name);
  set.beta = Image(spec);
  if (pixels.ambient) {
    set.ambient = pixels.ambient->clone();
    makeFinite(*set.ambient);  // pixels whose ambient light is no number are solved without it
  }
  return set;
}

/// Amplification up to which lights count as photographed one at a time.
constexpr double kOneByOne = 1.1;

/// Of the largest error of the colours that negative light is weighed for: what comes so near to it may be
/// larger still.
constexpr double kToldApart = 0.5;

/// Relative standard error of an unknown colour above which it is said to be hardly determined.
constexpr double kUnsure = 0.1;

/// A colour's value, with its shot's exposure taken off.
Rgb valueOf(const UnknownColor& unknown, const LightingMatrix& lighting, const Capture& capture) {
  const int entry = unknown.entries.front();
  const float stops = capture.shots[size_t(entry / lighting.lights)].exposureStops;
  return lighting.colors[size_t(entry)] * std::exp2(-stops);
}

/// A sentence for each colour that was not known: what it was found to be.
std::vector<std::string> estimatedColors(const std::vector<UnknownColor>& unknown,
                                         const LightingMatrix& lighting, const Capture& capture) {
  std::vector<std::string> sentences;
  for (const UnknownColor& one : unknown) {
    const Rgb color = valueOf(one, lighting, capture);
    sentences.push_back(fmt::format("{} was not known: estimated from the pictures as {:.3f}/{:.3f}/{:.3f}",
                                    withCapital(wordsFor(one, lighting)), color.r, color.g, color.b));
  }
  return sentences;
}

/// For checkSolvable: which unknown colour stands where.
std::vector<int> placesOf(const std::vector<UnknownColor>& unknown, const LightingMatrix& lighting) {
  std::vector<int> places(lighting.colors.size(), -1);
  for (size_t j = 0; j < unknown.size(); ++j)
    for (const int entry : unknown[j].entries) places[size_t(entry)] = int(j);
  return places;
}

}  // namespace

SolveRun::SolveRun(const Capture& given, const CapturePixels& photographs, const SolveOptions& options,
                   const SolveTuning& tuning, const Progress& progress, const std::vector<ShotShift>& movedBy)
    : m_given(given),
      m_photographs(photographs),
      m_options(options),
      m_tuning(tuning),
      m_progress(progress),
      m_info(options.solver.empty() ? estimatorFor(options.model) : estimatorInfo(options.solver)),
      m_capture(options.solveAmbient ? withAmbientLight(given, given.calledName()) : given) {
  m_context.lighting = lightingFromCapture(m_capture);
  m_unknownColors = unknownColorsOf(m_capture);
  checkSolvable(m_context.lighting, given.calledName(), placesOf(m_unknownColors, m_context.lighting));
  m_report.shifts = movedBy;
  m_report.solver = m_info.name;
  m_report.model = modelName(m_info.model);
  m_report.conditioning = conditioningOf(m_context.lighting);
  warn(m_capture.warnings);
  warn(photographs.warnings);
  warn(shiftWarnings(movedBy, given));
}

SolvedSet SolveRun::run() {
  m_progress.update(0, "Analysing the photographs");
  const bool fresh = m_report.shifts.empty();
  if (m_options.align == Remedy::On && fresh) alignShots();
  calibrateNoise();
  seekCauses();
  if (m_options.align == Remedy::Sure && fresh && m_report.causes.is(Cause::Moved)) alignMovedShots();
  if (m_options.align == Remedy::Sure && isAligned())
    warn(
        {"the camera surely moved between the photographs: they were aligned to the first (--align off "
         "leaves "
         "them as they are)"});
  const TriedRemedies tried{.aligned = !m_report.shifts.empty()};
  if (const std::string words = wordsFor(m_report.causes, tried); !words.empty()) warn({words});
  calibrateColors();
  separateLights();
  m_progress.update(0.9F, "Finishing");
  completePixels();
  finishReport();
  m_progress.update(1, "Solved");
  return std::move(m_set);
}

void SolveRun::warn(const std::vector<std::string>& warnings) {
  auto& said = m_report.warnings;
  for (const std::string& warning : warnings)
    if (std::find(said.begin(), said.end(), warning) == said.end()) said.push_back(warning);
}

void SolveRun::alignShots() {
  m_progress.update(0.02F, "Aligning the photographs");
  m_report.shifts = shiftsOfShots(m_given, m_photographs, m_options.noise, m_progress);
  if (m_options.align == Remedy::On || isAligned()) warn(shiftWarnings(m_report.shifts, m_given));
  if (isAligned()) m_aligned = movedShots(m_photographs, m_report.shifts);
}

bool SolveRun::isAligned() const {
  return std::any_of(m_report.shifts.begin(), m_report.shifts.end(), worthMoving);
}

/// The causes of the misfit are known for the photographs as they are: what they are when these lie on one
/// another is asked once more.
void SolveRun::alignMovedShots() {
  alignShots();
  if (!isAligned()) return;
  calibrateNoise();
  seekCauses();
}

void SolveRun::calibrateNoise() {
  const std::optional<SensorNoise> told = toldNoise(m_capture, m_options.noise);
  m_report.noiseGiven = told.has_value();
  m_report.noise = told ? *told : estimateSensorNoise(pixels());
  m_context.noise = noiseModel(m_report.noise, pixels(), 0);
  m_signal.emplace(pixels(), m_context.lighting, m_context.noise, exposures());
  placeUnknownColor();
  if (!m_report.noiseGiven) {
    m_ownNoise = residualNoise(m_context, codingNoise(pixels()), *m_signal, m_tuning.ownNoise);
    m_context.noise = calibratedNoise(m_context, *m_signal, m_tuning.noise);
  } else {
    m_ownNoise = m_context.noise;
  }
}

/// Before the colours are taken for what is wrong. With unknown ones they are; and lights that every channel
/// tells apart need no surface to be matte: what the matte model misses there is no misfit.
void SolveRun::seekCauses() {
  const auto& amplification = m_report.conditioning.amplification;
  const bool oneByOne = std::all_of(amplification.begin(), amplification.end(),
                                    [](double times) { return times > 0 && times <= kOneByOne; });
  if (!m_unknownColors.empty() || m_info.model == Model::Single || oneByOne) return;
  m_report.causes = misfitCauses({m_context.lighting, m_ownNoise}, *m_signal);
}

void SolveRun::placeUnknownColor() {
  const auto swapped = swappedColorOf(m_capture);
  if (!swapped) {
    if (m_options.openColor != OpenColorChoice{})
      warn(
          {"there is no unknown colour that has changed places with a known one: what was told of it is not "
           "used"});
    return;
  }
  const SwappedColorLine line =
      swappedColorLine(m_capture, *swapped, *m_signal, m_context.noise, m_tuning.swapped);
  if (!swapped->open) return startFromLine(*swapped, line);
  OpenColor open = chosenColor(m_capture, *swapped, *m_signal, line, m_options.openColor);
  setSwappedColor(*swapped, open.taken);
  open.name = wordsFor(m_unknownColors.front(), m_context.lighting);
  if (!open.settled) warn({wordsFor(open)});
  m_report.openColor = std::move(open);
}

void SolveRun::setSwappedColor(const SwappedColor& swapped, const Rgb& color) {
  const int lights = m_context.lighting.lights;
  for (int j = 0; j < 2; ++j)
    for (const UnknownColor& unknown : m_unknownColors)
      if (const int place = swapped.shots[j] * lights + 1 - swapped.lights[j];
          std::find(unknown.entries.begin(), unknown.entries.end(), place) != unknown.entries.end())
        for (const int entry : unknown.entries)
          m_context.lighting.colors[size_t(entry)] =
              color * std::exp2(m_capture.shots[size_t(entry / lights)].exposureStops);
}

/// Two photographs leave a line of colours, the others choose among them.
void SolveRun::startFromLine(const SwappedColor& swapped, const SwappedColorLine& line) {
  Rgb best = line.at(0);
  double least = INFINITY;
  for (const SwappedColorLine& side : {line, line.opposite()})
    for (const float position : {0.0F, 0.25F, 0.5F, 0.75F}) {
      setSwappedColor(swapped, side.at(position));
      const double misfit = fitColors(m_context, *m_signal, {}, m_tuning.colors).disagreement;
      if (misfit < least) least = misfit, best = side.at(position);
    }
  setSwappedColor(swapped, best);
}

void SolveRun::calibrateColors() {
  if (m_options.solveAmbient) {
    m_ambientColor = ambientColor(m_context, *m_signal, m_tuning.ambient);
    colorAmbient(m_context.lighting, m_ambientColor);
  }
  m_report.colorUncertainty = m_options.colorUncertainty;
  fitLightColors();
  if (!m_unknownColors.empty()) {
    m_report.estimated = estimatedColors(m_unknownColors, m_context.lighting, m_capture);
    m_report.conditioning = conditioningOf(m_context.lighting);
  }
  m_context.noise.square += m_report.colorUncertainty * m_report.colorUncertainty;
}

/// Learns from the pictures how far to trust the light colours, and refines them where asked to or where one
/// is unknown.
void SolveRun::fitLightColors() {
  // An open colour is as good as the photographs can say it; a fit would wander along its line.
  const bool refine = !m_report.openColor && (m_options.refineColors || !m_unknownColors.empty());
  if (!refine && m_options.colorUncertainty >= 0) return;
  ColorFitOptions fitOptions;
  fitOptions.rounds = refine ? 8 : 1;
  if (refine) fitOptions.unknown = m_unknownColors;
  // Unless asked to, what is told stays nearly as told: it is what the unknown is measured by.
  if (refine && !m_options.refineColors) fitOptions.priorSigma = 0.01;
  ColorFit fit = fitColors(m_context, *m_signal, fitOptions, m_tuning.colors);
  if (refine) {
    // What was only a start says nothing of how well the colours are known: ask again with the found ones.
    m_report.colorChange = fit.change;
    m_report.refinedColors = fit.lighting.colors;
    m_context.lighting = fit.lighting;
    for (size_t j = 0; j < fit.unknownError.size(); ++j)
      if (fit.unknownError[j] > kUnsure)
        warn({fmt::format(
            "{}: the photographs hardly determine this colour (to {:.0f} %): tell it, or take one "
            "more photograph under other colours",
            wordsFor(m_unknownColors[j], m_context.lighting), 100 * fit.unknownError[j])});
    fit = fitColors(m_context, *m_signal, {}, m_tuning.colors);
  }
  m_report.colorDisagreement = fit.disagreement;
  if (m_options.colorUncertainty >= 0) return;
  m_report.colorUncertainty = colorUncertaintyOf(fit, m_tuning.colors);
  float seen = m_report.colorUncertainty;  // by what something is said to be wrong: rather too much
  if (m_report.noiseGiven)
    doubtFittedError();
  else if (const float usual = usualColorUncertainty(m_report.noise, m_tuning.colors); usual > 0)
    seen = judgeColors(usual);
  if (!isUnnamed(m_report.causes, seen)) return;
  m_report.causes.unnamed = true;
  warn({wordsFor(m_report.causes)});
}

float SolveRun::colorErrorEverywhere() const {
  return swaplight::colorErrorEverywhere(m_context, *m_signal, m_tuning.colorEvidence, m_tuning.colors);
}

/// What the photographs show of the colours' error, besides what a fit of them has found; `everywhere`: what
/// the misfit asks for in all of the picture. Nothing where they show nothing.
std::optional<float> SolveRun::shownColorError(float everywhere) const {
  const float fitted = m_report.colorUncertainty;
  // Blocks of a JPEG have lost colour, which is no error of the lights': it spoils the fit, and neighbours
  // differ by little of it.
  const bool blocks = !pixels().codingError.empty();
  return colorUncertaintyByEvidence({m_context.lighting, m_ownNoise}, *m_signal,
                                    blocks ? std::max(fitted, everywhere) : fitted, m_tuning.colorEvidence);
}

/// Where the noise is told: gloss, bounced light and relief, too, are misfit that noise does not explain. The
/// colours are wrong by no more than light that comes out negative says, up to the errors that it can tell
/// apart, but where a camera that moved makes it so.
void SolveRun::doubtFittedError() {
  if (m_report.causes.is(Cause::Moved)) return;
  const std::optional<float> shown = shownColorError(colorErrorEverywhere());
  if (shown && *shown < kToldApart * m_tuning.colorEvidence.largest)
    m_report.colorUncertainty = std::min(m_report.colorUncertainty, *shown);
}

/// Where the noise is not told: how wrong the colours are, and what of the matte model's misfit that
/// explains. The rest is the set's own, no error that it may hide in. Returns what the photographs show of
/// the colours' error, without what is only assumed.
float SolveRun::judgeColors(float usual) {
  const ColorEvidenceTuning& tuning = m_tuning.colorEvidence;
  const float fitted = m_report.colorUncertainty;
  const float everywhere = colorErrorEverywhere();
  const std::optional<float> judged = shownColorError(everywhere);
  const bool blocks = !pixels().codingError.empty();
  // Where no light is blocked anywhere the fit alone speaks, if there are photographs enough.
  const bool few = m_context.lighting.shots < m_context.lighting.lights;
  const float unseen = few || blocks ? usual : float(tuning.unseen);
  m_report.colorUncertainty = judged.value_or(std::max(fitted, unseen));
  const auto level = float(tuning.level);
  const float own = m_ownNoise.variance(level);
  const float excess = m_context.noise.variance(level) - own;
  if (!blocks && excess < -float(tuning.unmeasured) * own)
    return judged.value_or(fitted);  // there was nothing to measure the pixels' own by
  // Where no misfit is smooth enough to be the colours', they explain of it what their error does to a pixel.
  const float seen = std::max(fitted, everywhere) > float(tuning.unseen)
                         ? m_report.colorUncertainty / std::max(fitted, everywhere)
                         : m_report.colorUncertainty * level / std::sqrt(std::max(excess, 1e-12F));
  const float part = std::min(seen * seen, 1.0F);
  m_context.noise = withModelError(m_ownNoise, m_context.noise, part);
  return judged.value_or(fitted);
}

/// Misfit at edges is a moved camera's only where that explains any of it: relief and gloss are at edges,
/// too. Photographs that were moved onto one another, and JPEGs, are never quite alike there.
bool SolveRun::mayHaveMoved() const {
  if (isAligned() || !pixels().codingError.empty()) return true;
  const auto& causes = m_report.causes.all;
  const auto moved = std::find_if(causes.begin(), causes.end(),
                                  [](const CauseEvidence& one) { return one.cause == Cause::Moved; });
  return moved == causes.end() || moved->explained > m_tuning.notMoved;
}

void SolveRun::separateLights() {
  m_set = emptySet(m_capture, pixels());
  m_set.carried = m_photographs.carried;
  if (m_info.model != Model::Auto)
    return solvePixelwise(m_info, m_context, *m_signal, m_set, m_progress.part(0.1F, 0.9F));
  const float shift =
      solveAuto(m_context, *m_signal, m_report.shifts, mayHaveMoved(), m_tuning.automatic, m_set, m_progress);
  // Photographs that do not lie on one another, and JPEGs, differ by more than noise says.
  if (shift == 0 && !isAligned() && pixels().codingError.empty())
    followLocalEvidence({m_context.lighting, m_ownNoise}, m_report.colorUncertainty, *m_signal,
                        m_tuning.automatic.evidence, m_set);
  // Gloss, grain and wrong colours are at edges, too.
  const bool registered = !m_report.shifts.empty();
  if (shift > 0 && (m_report.causes.all.empty() || registered))
    m_report.warnings.emplace_back(
        registered
            ? "the photographs still disagree along edges: trusted less there"
            : "the photographs disagree along edges, as if the camera had moved by a fraction of a pixel: "
              "trusted less there; aligning may help (--align on)");
}

std::vector<float> SolveRun::exposures() const {
  std::vector<float> exposures;
  for (const Shot& shot : m_capture.shots) exposures.push_back(std::exp2(shot.exposureStops));
  return exposures;
}

void SolveRun::completePixels() {
  if (m_info.model != Model::Single && markMoved(m_context, *m_signal, m_set, m_tuning.motion) > 0)
    updateBeta(m_set);
  const std::vector<uint8_t> missing = writeFlags(pixels(), *m_signal, m_tuning.tooDarkSigma, m_set);
  m_report.lost = m_signal->lostPixels();
  if (!missing.empty()) {
    for (Image& contribution : m_set.contributions) fillFromNeighbours(contribution, missing);
    updateBeta(m_set);
  }
  if (keepWithinClippedBounds({m_context.lighting, m_ownNoise}, exposures(), *m_signal,
                              m_tuning.automatic.clipped.modelError, m_set) > 0)
    updateBeta(m_set);
  if (m_info.model == Model::Auto &&
      restoreClippedLight(m_context, *m_signal, m_tuning.automatic.clipped, m_set) > 0)
    updateBeta(m_set);
  flagOutside(m_report.shifts, m_set);
  fillDarkBeta(m_set);
  if (m_options.denoise == Denoise::Guided) {
    denoiseGuided(m_set, m_context, m_options.guidedRadius);
    updateBeta(m_set);
    fillDarkBeta(m_set);
  }
  if (m_options.solveAmbient) takeAmbientOut(m_given, m_ambientColor, m_set);
}

void SolveRun::finishReport() {
  m_report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_started).count();
  m_report.options = jsonFromSolveOptions(m_options);
  summarize(m_set, m_report);
  m_set.report = std::move(m_report);
}

}  // namespace swaplight
