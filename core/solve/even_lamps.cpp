#include "core/solve/even_lamps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/field/drift_fit.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/unknown_color.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_shots.h"
#include "core/solve/signal_scale.h"

namespace swaplight {
namespace {

constexpr int kMostRounds = 4;
constexpr double kSettled = 1e-3;   // RMS change of the shots, relative to them
constexpr int kEvenRows = 32;       // at once
constexpr float kMostRoom = 4;      // times the clip level
constexpr float kLiftOverRoom = 2;  // how much darker even lamps may make a saturated pixel
constexpr int kPlaces = 9;          // a side, at which a field's least value is looked for

/// What the lamps' colours were, exposure included: [shot][light], as told or as the solve has found them.
std::vector<std::vector<Rgb>> colorsOf(const Capture& capture, const SolveReport& report) {
  const size_t shots = capture.shots.size(), lights = capture.lights.size();
  std::vector<Rgb> colors = lightingFromCapture(capture).colors;
  size_t stride = lights;
  if (!report.refinedColors.empty()) {
    colors = report.refinedColors;
    stride = colors.size() / shots;  // ambient light that was solved for is one more
  } else if (report.openColor) {
    for (const UnknownColor& unknown : unknownColorsOf(capture))
      for (const int entry : unknown.entries)
        colors[static_cast<size_t>(entry)] =
            report.openColor->taken *
            std::exp2(capture.shots[static_cast<size_t>(entry) / lights].exposureStops);
  }
  std::vector<std::vector<Rgb>> result;
  for (size_t k = 0; k < shots; ++k)
    result.emplace_back(colors.begin() + static_cast<ptrdiff_t>(k * stride),
                        colors.begin() + static_cast<ptrdiff_t>(k * stride + lights));
  return result;
}

/// The shots of lamps that are uneven, and of the same lamps if they were not.
class EvenedShots {
 public:
  EvenedShots(const CapturePixels& uneven, const FlatFields& fields)
      : m_uneven(uneven), m_fields(fields), m_even(withoutShots(uneven)) {
    for (const Image& shot : uneven.shots) m_even.shots.push_back(shot.clone());
    // What is added makes no pixel saturated, and what is taken keeps those saturated that are.
    for (size_t k = 0; k < m_even.clipLevel.size(); ++k) {
      const float room = roomOf(fields.lamps[k]);
      m_even.clipLevel[k] *= room;
      m_even.clippedLift.push_back(kLiftOverRoom * room);
    }
  }

  [[nodiscard]] const CapturePixels& pixels() const { return m_even; }

  /// Evens the shots by what is known of the lights; returns their RMS change, relative.
  double update(const std::vector<std::vector<Rgb>>& colors, const std::vector<Image>& lights) {
    double change = 0, signal = 0;
    for (size_t k = 0; k < m_even.shots.size(); ++k) updateShot(k, colors[k], lights, change, signal);
    return signal > 0 ? std::sqrt(change / signal) : 0;
  }

 private:
  /// How much brighter even lamps can make a pixel of a shot.
  static float roomOf(const std::vector<std::optional<SmoothField>>& lamps) {
    double least = 1;
    for (const auto& field : lamps)
      for (int j = 0; field && j < 3 * kPlaces * kPlaces; ++j)
        least = std::min(least, field->at(j % 3, 2.0 * (j / 3 % kPlaces) / (kPlaces - 1) - 1,
                                          2.0 * double(j / 3 / kPlaces) / (kPlaces - 1) - 1));
    return std::min(static_cast<float>(1.02 / std::max(least, 1e-3)), kMostRoom);
  }

  void updateShot(size_t k, const std::vector<Rgb>& colors, const std::vector<Image>& lights, double& change,
                  double& signal) {
    Image& even = m_even.shots[k];
    const int width = even.width(), height = even.height();
    std::vector<double> changes(static_cast<size_t>(height), 0), signals(static_cast<size_t>(height), 0);
    parallelRows(height, kEvenRows, [&](int begin, int end) {
      std::vector<float> next(static_cast<size_t>(width)), factor(static_cast<size_t>(width));
      for (int y = begin; y < end; ++y)
        for (int c = 0; c < 3; ++c) {
          evenRow(k, c, y, colors, lights, next, factor);
          float* row = even.span().row(c, y);
          for (size_t x = 0; x < next.size(); ++x) {
            if (std::isfinite(next[x]) && next[x] < m_even.clipLevel[k]) {
              changes[static_cast<size_t>(y)] += std::pow(double(next[x]) - row[x], 2);
              signals[static_cast<size_t>(y)] += std::pow(double(row[x]), 2);
            }
            row[x] = next[x];
          }
        }
    });
    for (size_t y = 0; y < changes.size(); ++y) change += changes[y], signal += signals[y];
  }

  void evenRow(size_t k, int c, int y, const std::vector<Rgb>& colors, const std::vector<Image>& lights,
               std::vector<float>& next, std::vector<float>& factor) const {
    const float* shot = m_uneven.shots[k].view().row(c, y);
    const float clip = m_uneven.clipLevel[k];
    std::copy_n(shot, next.size(), next.begin());
    for (size_t i = 0; i < lights.size(); ++i) {
      const auto& field = m_fields.lamps[k][i];
      if (!field) continue;
      field->row(c, y, static_cast<int>(next.size()), m_even.height(), factor.data());
      const float* light = lights[i].view().row(c, y);
      for (size_t x = 0; x < next.size(); ++x) next[x] += colors[i][c] * (1 - factor[x]) * light[x];
    }
    const float evenClip = m_even.clipLevel[k], below = std::nextafter(evenClip, 0.0F);
    for (size_t x = 0; x < next.size(); ++x)
      next[x] =
          shot[x] >= clip ? std::max(next[x] * m_even.clippedLift[k], evenClip) : std::min(next[x], below);
  }

  const CapturePixels& m_uneven;
  const FlatFields& m_fields;
  CapturePixels m_even;
};

Progress partOfRound(const Progress& progress, int round) {
  return progress.part(float(round) / (kMostRounds + 1), float(round + 1) / (kMostRounds + 1));
}

/// Only to stop by: what it looks at takes a small part of a solve.
Progress silent(const Progress& progress) {
  return {{}, progress.stop};
}

/// The photographs as a solve has moved them onto one another; nothing where it has left them.
std::optional<CapturePixels> movedAsIn(const SolvedSet& set, const CapturePixels& photographs) {
  const std::vector<ShotShift>& shifts = set.report->shifts;
  if (std::none_of(shifts.begin(), shifts.end(), worthMoving)) return std::nullopt;
  return movedShots(photographs, shifts);
}

/// `set`: what even lamps would have given, solved in the first part of `progress`. All rounds lie where it
/// has moved the photographs.
SolvedSet solveUnevenLamps(SolvedSet set, const Capture& capture, const CapturePixels& photographs,
                           const FlatFields& fields, const SolveOptions& options, const Progress& progress) {
  const std::optional<CapturePixels> moved = movedAsIn(set, photographs);
  const std::vector<ShotShift> shifts = set.report->shifts;
  SolveOptions again = options;
  if (shifts.empty()) again.align = Remedy::Off;
  EvenedShots shots(moved ? *moved : photographs, fields);
  double seconds = set.report->seconds;
  for (int round = 1; round <= kMostRounds; ++round) {
    if (shots.update(colorsOf(capture, *set.report), set.contributions) < kSettled) break;
    set = solve(capture, shots.pixels(), again, partOfRound(progress, round), {}, shifts);
    set.report->options = jsonFromSolveOptions(options);
    seconds += set.report->seconds;
  }
  set.report->seconds = seconds;
  return set;
}

/// Photographs without what the lens takes.
CapturePixels throughNoLens(const CapturePixels& photographs, const SmoothField& lens) {
  CapturePixels pixels = withoutShots(photographs);
  for (const Image& shot : photographs.shots) lens.takeFrom(pixels.shots.emplace_back(shot.clone()));
  if (photographs.ambient) lens.takeFrom(pixels.ambient.emplace(photographs.ambient->clone()));
  return pixels;
}

/// The drift that the photographs show, as a solve would see them. A coloured lens is no drift of the lamps.
std::optional<LampDrift> seenDrift(const Capture& capture, const CapturePixels& photographs,
                                   const std::optional<SmoothField>& lens, const SolveOptions& options,
                                   const Progress& progress) {
  if (lens) return seenDrift(capture, throughNoLens(photographs, *lens), {}, options, progress);
  const std::string where = capture.calledName();
  std::optional<SensorNoise> noise = toldNoise(capture, options.noise);
  const float scale = signalScale(photographs, where);
  if (noise) noise = scaledNoise(*noise, scale);
  std::optional<CapturePixels> scaled;
  if (scale != 1) scaled = scaledSignal(photographs, scale);
  return findDrift(capture, scaled ? *scaled : photographs, noise, progress);
}

LampField fieldInReport(const std::string& light, const SmoothField& field, double size) {
  LampField found{light, size, {}};
  for (size_t j = 0; j < found.corners.size(); ++j)
    for (int c = 0; c < 3; ++c)
      found.corners[j][size_t(c)] = field.at(c, j % 2 == 0 ? -1 : 1, j < 2 ? -1 : 1);
  return found;
}

/// solve() of lamps that are evened as far as the photographs show them to drift.
SolvedSet solveDriftingLamps(const Capture& capture, const CapturePixels& photographs,
                             const std::optional<SmoothField>& lens, const SolveOptions& options,
                             const Progress& progress) {
  SolvedSet set = solve(capture, photographs, options, partOfRound(progress, 0));
  const auto asItIs = [&](const char* why) {
    set.report->warnings.emplace_back(std::string(why) + ": nothing was evened");
    return std::move(set);
  };
  if (options.solveAmbient)
    return asItIs("the lamps' drift is not looked for where ambient light is solved for (--field)");
  if (set.report->causes.all.empty())
    return asItIs(
        "whether the lamps' colour drifts over the picture cannot be told of these photographs: a colour is "
        "unknown, the lamps were lit one at a time, or the photographs are too few, too dark, or more than "
        "can be compared (--field)");
  const std::optional<LampDrift> drift = [&] {
    const std::optional<CapturePixels> moved = movedAsIn(set, photographs);
    return seenDrift(capture, moved ? *moved : photographs, lens, options, silent(progress));
  }();
  if (!drift) return asItIs("the photographs do not surely show lamps whose colour drifts over the picture");
  FlatFields fields;
  std::vector<LampField> found;
  double largest = 0;
  for (int i = 0; i < capture.lightCount(); ++i) {
    found.push_back(fieldInReport(capture.lights[size_t(i)].name, drift->field(i), drift->size(i)));
    largest = std::max(largest, drift->size(i));
  }
  for (size_t k = 0; k < capture.shots.size(); ++k) {
    auto& lamps = fields.lamps.emplace_back();
    for (int i = 0; i < capture.lightCount(); ++i) lamps.emplace_back(drift->field(i));
  }
  set = solveUnevenLamps(std::move(set), capture, photographs, fields, options, progress);
  set.report->lampFields = std::move(found);
  set.report->message += fmt::format(
      " The lamps' colours were evened as the photographs show them to drift, by up to {:.1f} % (RMS).",
      100 * largest);
  return set;
}

SolvedSet solveLamps(const Capture& capture, const CapturePixels& photographs, const FlatFields& fields,
                     const SolveOptions& options, const Progress& progress) {
  if (fields.lamps.empty())
    return options.field ? solveDriftingLamps(capture, photographs, fields.lens, options, progress)
                         : solve(capture, photographs, options, progress);
  SolvedSet set = solveUnevenLamps(solve(capture, photographs, options, partOfRound(progress, 0)), capture,
                                   photographs, fields, options, progress);
  set.report->message += " The lamps' colours were evened by their flat fields.";
  if (options.field)
    set.report->warnings.emplace_back("the lamps have flat fields: their drift was not looked for (--field)");
  return set;
}

}  // namespace

SolvedSet solveUneven(const Capture& capture, const CapturePixels& photographs, const FlatFields& fields,
                      const SolveOptions& options, const Progress& progress) {
  SolvedSet set = solveLamps(capture, photographs, fields, options, progress);
  if (fields.lens) {
    for (Image& light : set.contributions) fields.lens->takeFrom(light);
    if (set.ambient) fields.lens->takeFrom(*set.ambient);
    set.report->message += " What the lens takes of the light was given back.";
  }
  auto& warnings = set.report->warnings;
  warnings.insert(warnings.end(), fields.warnings.begin(), fields.warnings.end());
  return set;
}

}  // namespace swaplight
