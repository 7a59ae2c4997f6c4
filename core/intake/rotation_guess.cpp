#include "core/intake/rotation_guess.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/solve/calibration/color_fit.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/noise_model.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {
namespace {

/// Relative error of the light colours that plans are compared under: real gels are known to a few per cent.
/// It also keeps pictures without noise from dividing by nothing.
constexpr float kColorError = 0.03F;
// By judgement: they choose the words; the guess is the best plan whatever they are. A misfit is
// ColorFit::disagreement.
constexpr double kBad = 0.15;  ///< a misfit five times the colours' error: they are hardly those colours
constexpr double kSure = 0.7;  ///< of the next best plan's misfit: nearer than that, noise may have decided

/// Every way to go on from a first shot, shot by shot.
void addPlans(int lights, size_t shots, bool repeat, std::vector<int>& steps,
              std::vector<std::vector<int>>& plans) {
  if (plans.size() > kMostPlans) return;
  if (steps.size() == shots) {
    plans.push_back(steps);
    return;
  }
  for (int step = 0; step < lights; ++step) {
    if (!repeat && std::find(steps.begin(), steps.end(), step) != steps.end()) continue;
    steps.push_back(step);
    addPlans(lights, shots, repeat, steps, plans);
    steps.pop_back();
  }
}

std::vector<std::vector<int>> plansToTry(int lights, size_t shots) {
  std::vector<std::vector<int>> plans;
  std::vector<int> steps{0};
  addPlans(lights, shots, shots > static_cast<size_t>(lights), steps, plans);
  if (plans.size() <= kMostPlans) return plans;
  plans.clear();
  for (const int direction : {1, lights - 1}) {
    std::vector<int> steady;
    for (size_t k = 0; k < shots; ++k)
      steady.push_back(static_cast<int>(k * static_cast<size_t>(direction) % static_cast<size_t>(lights)));
    plans.push_back(std::move(steady));
  }
  return plans;
}

/// What the matte model leaves of bright pixels under a plan.
double misfitOf(const CaptureDraft& draft, const CapturePixels& pixels, const NoiseModel& noise) {
  const Capture capture = captureOf(draft);
  const EstimatorContext context{lightingFromCapture(capture), noise};
  std::vector<float> exposure;
  for (const Shot& shot : capture.shots) exposure.push_back(std::exp2(shot.exposureStops));
  return fitColors(context, ShotSignal(pixels, context.lighting, noise, exposure)).disagreement;
}

std::string wordsFor(const RotationGuess& guess) {
  std::string words;
  if (guess.tried < 2)
    words = fmt::format("guessed, the only possible rotation (misfit {:.1f} %)", 100 * guess.misfit);
  else
    words = fmt::format("guessed, the best of {} rotations (misfit {:.1f} %, next {:.1f} %)", guess.tried,
                        100 * guess.misfit, 100 * guess.nextMisfit);
  if (guess.misfit > kBad)
    words += ": poor fit, check the colours";
  else if (guess.tried > 1 && guess.misfit > kSure * guess.nextMisfit)
    words += ": not sure, please check";
  return words;
}

}  // namespace

CaptureDraft withRotation(CaptureDraft draft, const std::vector<ShotColor>& ring,
                          const std::vector<int>& steps) {
  std::vector<ShotColor> colors(draft.lights.size());
  for (size_t lighting = 0; lighting < draft.lightings(); ++lighting) {
    for (size_t i = 0; i < colors.size(); ++i)
      colors[i] = ring[(i + static_cast<size_t>(steps[lighting])) % ring.size()];
    setLighting(draft, lighting, colors);
  }
  return draft;
}

RotationGuess guessRotation(const CaptureDraft& draft, const CapturePixels& pixels,
                            const std::vector<ShotColor>& ring) {
  if (ring.size() != draft.lights.size())
    throw InputError("{} colours for {} lights: give one colour a light, as each had it in the first shot",
                     ring.size(), draft.lights.size());
  for (const ShotColor& color : ring)
    if (!color.color)
      throw InputError("how the colours moved can only be guessed where all of them are known");
  RotationGuess guess;
  const NoiseModel noise = noiseModel(estimateSensorNoise(pixels), pixels, kColorError);
  guess.misfit = guess.nextMisfit = INFINITY;
  for (const std::vector<int>& steps : plansToTry(static_cast<int>(ring.size()), draft.lightings())) {
    const double misfit = misfitOf(withRotation(draft, ring, steps), pixels, noise);
    ++guess.tried;
    if (misfit < guess.misfit) {
      guess.nextMisfit = std::exchange(guess.misfit, misfit);
      guess.steps = steps;
    } else {
      guess.nextMisfit = std::min(guess.nextMisfit, misfit);
    }
  }
  if (guess.tried < 2) guess.nextMisfit = 0;
  guess.words = wordsFor(guess);
  return guess;
}

}  // namespace swaplight
