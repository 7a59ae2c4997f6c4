#include "core/solve/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/parallel.h"
#include "core/set/fill.h"
#include "core/solve/auto/auto_solve.h"
#include "core/solve/calibration/ambient_light.h"
#include "core/solve/calibration/color_fit.h"
#include "core/solve/calibration/noise_calibration.h"
#include "core/solve/denoise.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/pixel_batch.h"
#include "core/solve/model/shot_signal.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_pixels.h"
#include "core/solve/report_summary.h"
#include "core/solve/signal_scale.h"

namespace swaplight {
namespace {

constexpr float kTooDarkSigma = 0.25F;  // a share known no better than this is no answer

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
  if (pixels.ambient) set.ambient = pixels.ambient->clone();
  return set;
}

/// Solves the flagged pixels of a run again with an estimator that can leave values out.
void repairRun(const ShotSignal& signal, size_t first, int count, const Estimator& careful, int lights,
               int shots, const SolvedRun& out) {
  std::vector<int> index;
  for (int p = 0; p < count; ++p)
    if (signal.flags()[first + size_t(p)]) index.push_back(p);
  if (index.empty()) return;
  std::vector<float> scratch;
  PixelRun all;
  signal.run(first, count, true, scratch, all);
  const PixelBatch batch(all, std::move(index), shots, lights);
  careful.estimate(batch.in(), batch.out());
  batch.scatter(out);
}

/// One estimator, one stream over the shots.
void solveWithEstimator(const EstimatorInfo& info, const EstimatorContext& context, const ShotSignal& signal,
                        SolvedSet& set, const Progress& progress) {
  const auto estimator = info.make(context);
  const auto careful =
      info.masks || signal.flags().empty() ? nullptr : estimatorFor(Model::Lambert).make(context);
  const int runs = int((signal.pixelCount() + kRun - 1) / kRun);
  std::atomic<int> done = 0;
  parallelRows(runs, 4, [&](int begin, int end) {
    std::vector<float> scratch;
    for (int r = begin; r < end; ++r) {
      const size_t first = size_t(r) * kRun;
      const int count = int(std::min<size_t>(kRun, signal.pixelCount() - first));
      PixelRun in;
      signal.run(first, count, info.masks, scratch, in);
      const SolvedRun out = runAt(set, first);
      estimator->estimate(in, out);
      if (careful && signal.flagged(first, count))
        repairRun(signal, first, count, *careful, context.plan.lights, context.plan.shots, out);
      writeBeta(context.plan.lights, count, out);
    }
    progress.update(0.1F + 0.8F * float(done += end - begin) / float(runs), "Separating lights");
  });
}

/// Learns from the pictures how far to trust the light colours, and refines them where asked to or where one
/// is unknown.
void fitLightColors(const SolveOptions& options, const std::vector<int>& unknown, const ShotSignal& signal,
                    EstimatorContext& context, SolveReport& report) {
  const bool refine = options.refineColors || !unknown.empty();
  if (!refine && options.colorUncertainty >= 0) return;
  ColorFitOptions fitOptions;
  fitOptions.rounds = refine ? 8 : 1;
  fitOptions.unknown = unknown;
  ColorFit fit = fitColors(context, signal, fitOptions);
  if (refine) {
    // What was only a start says nothing of how well the colours are known: ask again with the found ones.
    report.colorChange = fit.change;
    report.refinedColors = fit.plan.colors;
    context.plan = fit.plan;
    fit = fitColors(context, signal);
  }
  report.colorDisagreement = fit.disagreement;
  if (options.colorUncertainty < 0) {
    report.colorUncertainty = colorUncertaintyOf(fit);
    if (!report.noiseGiven)
      report.colorUncertainty = std::max(report.colorUncertainty, usualColorUncertainty(report.noise));
  }
}

/// In words, what the colours that nobody knew were found to be.
std::vector<std::string> estimatedColors(const std::vector<int>& unknown, const LightPlan& plan) {
  std::vector<std::string> words;
  for (const int entry : unknown) {
    const int shot = entry / plan.lights, light = entry % plan.lights;
    const Rgb& color = plan.color(shot, light);
    words.push_back(fmt::format(
        "The colour of {} in shot {} was not known: estimated from the pictures as {:.3f}/{:.3f}/{:.3f}",
        plan.names[size_t(light)], shot + 1, color.r, color.g, color.b));
  }
  return words;
}

/// Writes the flags; returns the pixels that nothing is known of (no shot has a finite value in some
/// channel).
std::vector<uint8_t> writeFlags(const CapturePixels& pixels, const ShotSignal& signal, SolvedSet& set) {
  float* flags = set.quality.plane(kFlags);
  const float* sigma = set.quality.plane(kSigma);
  std::vector<uint8_t> unknown;
  for (size_t p = 0; p < signal.pixelCount(); ++p) {
    int bits = int(flags[p]) | (signal.flags().empty() ? 0 : signal.flags()[p]);
    if (sigma[p] > kTooDarkSigma) bits |= kTooDark;
    if (bits & kNotFinite) {
      for (int c = 0; c < 3; ++c) {
        bool known = false;
        for (const Image& shot : pixels.shots) known |= std::isfinite(shot.plane(c)[p]);
        if (known) continue;
        if (unknown.empty()) unknown.resize(signal.pixelCount(), 0);
        unknown[p] = 1;
        bits |= kFilled;
      }
    }
    flags[p] = float(bits);
  }
  return unknown;
}

/// Pixels that a moved shot does not show are marked as filled in: from its edge.
void flagOutside(const std::vector<ShotShift>& shifts, SolvedSet& set) {
  if (std::none_of(shifts.begin(), shifts.end(), worthMoving)) return;
  const int width = set.quality.width();
  const int height = set.quality.height();
  float* flags = set.quality.plane(kFlags);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (outsideAny(shifts, x, y, width, height)) {
        float& pixel = flags[size_t(y) * size_t(width) + size_t(x)];
        pixel = float(int(pixel) | kFilled);
      }
}

/// A pixel too dark to tell is given its neighbours' proportions; its light, such as it is, stays.
void fillDarkBeta(SolvedSet& set) {
  float* flags = set.quality.plane(kFlags);
  std::vector<uint8_t> dark(set.beta.pixelCount(), 0);
  size_t count = 0;
  for (size_t p = 0; p < dark.size(); ++p)
    if (int(flags[p]) & kTooDark) dark[p] = 1, ++count;
  if (count == 0 || count == dark.size()) return;
  fillFromNeighbours(set.beta, dark);
  for (size_t p = 0; p < dark.size(); ++p) {
    if (!dark[p]) continue;
    flags[p] = float(int(flags[p]) | kFilled);
    float sum = 0;
    for (int i = 0; i < set.lightCount(); ++i) sum += set.beta.plane(i)[p];
    for (int i = 0; i < set.lightCount(); ++i)
      set.beta.plane(i)[p] = sum > 0 ? set.beta.plane(i)[p] / sum : 1.0F / float(set.lightCount());
  }
}

/// Pictures far from full scale, as radiance in physical units may be: solved around 1, and scaled back.
SolvedSet solveScaled(const Capture& given, const CapturePixels& photographs, const SolveOptions& options,
                      float scale, const Progress& progress) {
  Capture capture = given;
  SolveOptions scaled = options;
  for (auto* noise : {&capture.noise, &scaled.noise})
    if (*noise) *noise = scaledNoise(**noise, scale);
  SolvedSet set = solve(capture, scaledSignal(photographs, scale), scaled, progress);
  unscale(set, scale);
  set.capture.noise = given.noise;
  set.report->options = jsonFromSolveOptions(options);
  set.report->noise = scaledNoise(set.report->noise, 1 / scale);
  return set;
}

}  // namespace

SolvedSet solve(const Capture& given, const CapturePixels& photographs, const SolveOptions& options,
                const Progress& progress) {
  options.check();
  const auto started = std::chrono::steady_clock::now();
  const std::string where = given.file.empty() ? given.name : given.file.filename().string();
  if (const float scale = signalScale(photographs, where); scale != 1)
    return solveScaled(given, photographs, options, scale, progress);
  const Capture capture = options.solveAmbient ? withAmbientLight(given, where) : given;
  progress.update(0, "Analysing the photographs");
  SolveReport report;
  report.warnings = capture.warnings;
  const auto warn = [&](const std::vector<std::string>& warnings) {
    report.warnings.insert(report.warnings.end(), warnings.begin(), warnings.end());
  };
  warn(photographs.warnings);

  EstimatorContext context;
  std::vector<int> unknown;
  context.plan = planFromCapture(capture, &unknown);
  checkSolvable(context.plan, where);
  report.conditioning = conditioningOf(context.plan);

  std::optional<CapturePixels> aligned;
  if (options.align) {
    progress.update(0.02F, "Aligning the photographs");
    report.shifts = measureShifts(photographs);
    warn(shiftWarnings(report.shifts));
    if (std::any_of(report.shifts.begin(), report.shifts.end(), worthMoving))
      aligned = movedShots(photographs, report.shifts);
  }
  const CapturePixels& pixels = aligned ? *aligned : photographs;

  const EstimatorInfo& info =
      options.solver.empty() ? estimatorFor(options.model) : estimatorInfo(options.solver);
  report.solver = info.name;
  report.model = modelName(info.model);
  report.noiseGiven = options.noise || capture.noise;
  report.noise = options.noise   ? *options.noise
                 : capture.noise ? *noiseInFrame(capture)
                                 : estimateSensorNoise(pixels);
  std::vector<float> exposure;
  for (const Shot& shot : capture.shots) exposure.push_back(std::exp2(shot.exposureStops));
  context.noise = noiseModel(report.noise, pixels, 0);
  const ShotSignal signal(pixels, context.plan, context.noise, exposure);
  if (!report.noiseGiven) context.noise = calibratedNoise(context, signal);
  Rgb ambient(1);
  if (options.solveAmbient) {
    ambient = ambientColor(context, signal);
    colorAmbient(context.plan, ambient);
  }
  report.colorUncertainty = options.colorUncertainty;
  fitLightColors(options, unknown, signal, context, report);
  if (!unknown.empty()) {
    report.estimated = estimatedColors(unknown, context.plan);
    report.conditioning = conditioningOf(context.plan);
  }
  context.noise.square += report.colorUncertainty * report.colorUncertainty;

  SolvedSet set = emptySet(capture, pixels);
  set.carried = photographs.carried;
  if (info.model == Model::Auto) {
    if (solveAuto(context, signal, report.shifts, set, progress) > 0)
      report.warnings.emplace_back(options.align
                                       ? "the photographs still disagree along edges: trusted less there"
                                       : "the photographs disagree along edges, as if the camera had moved "
                                         "by a fraction of a pixel: trusted less there; --align may help");
  } else {
    solveWithEstimator(info, context, signal, set, progress);
  }

  progress.update(0.9F, "Finishing");
  if (info.model != Model::Single && markMoved(context, signal, set) > 0) updateBeta(set);
  const std::vector<uint8_t> missing = writeFlags(pixels, signal, set);
  if (!missing.empty()) {
    for (Image& contribution : set.contributions) fillFromNeighbours(contribution, missing);
    updateBeta(set);
  }
  flagOutside(report.shifts, set);
  fillDarkBeta(set);
  if (options.denoise == Denoise::Guided) {
    denoiseGuided(set, context, options.guidedRadius);
    updateBeta(set);
    fillDarkBeta(set);
  }

  if (options.solveAmbient) takeAmbientOut(given, ambient, set);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  report.options = jsonFromSolveOptions(options);
  summarize(set, report);
  set.report = std::move(report);
  progress.update(1, "Solved");
  return set;
}

}  // namespace swaplight
