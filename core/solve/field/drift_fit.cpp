#include "core/solve/field/drift_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/image/shrunk_image.h"
#include "core/linear/decompositions.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/cause_evidence.h"
#include "core/solve/field/drift_evidence.h"

namespace swaplight {
namespace {

constexpr const char* kWhat = "looking how the lamps' colours drift";
constexpr float kNeverClipped = std::numeric_limits<float>::infinity();

/// A picture of at most so many pixels across, what is saturated being no number.
Image averaged(const Image& image, float clip, int width, int height) {
  Image usable = image.clone();
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < usable.pixelCount(); ++p)
      if (float& value = usable.plane(c)[p]; value >= clip) value = NAN;
  return width == image.width() ? std::move(usable) : shrunkImage(usable, width, height);
}

struct Averaged {
  CapturePixels pixels;
  double each = 1;  ///< pixels that became one
};

Averaged averagedPhotographs(const CapturePixels& photographs, int across) {
  const double factor = std::min(1.0, double(across) / std::max(photographs.width(), photographs.height()));
  const int width = std::max(1, int(std::lround(factor * photographs.width())));
  const int height = std::max(1, int(std::lround(factor * photographs.height())));
  Averaged result{withoutShots(photographs),
                  double(photographs.width()) * photographs.height() / (double(width) * height)};
  for (size_t k = 0; k < photographs.shots.size(); ++k)
    result.pixels.shots.push_back(averaged(photographs.shots[k], photographs.clipLevel[k], width, height));
  if (photographs.ambient)
    result.pixels.ambient = averaged(*photographs.ambient, kNeverClipped, width, height);
  for (float& step : result.pixels.quantum) step /= float(std::sqrt(result.each));
  // Neighbours share a part of a JPEG's error: less is averaged out than of noise (scaleDown in
  // capture_pixels.cpp has what was measured).
  for (ValueVariance& at : result.pixels.codingError) at.variance *= float(factor);
  return result;
}

void checkKnown(const Capture& capture) {
  for (const Shot& shot : capture.shots)
    for (const auto& color : shot.lightColors)
      if (!color)
        throw InputError(
            "{}: a light colour is unknown, so that no drift over the field can be told from the "
            "photographs; tell the colour, or let the lamps count as even (--field left out)",
            capture.calledName());
}

}  // namespace

std::optional<LampDrift> findDrift(const Capture& capture, const CapturePixels& photographs,
                                   const std::optional<SensorNoise>& noise, const Progress& progress,
                                   const FieldTuning& tuning) {
  checkKnown(capture);
  if (capture.shotCount() > kMaxShots || capture.lightCount() > kMaxLights)
    return std::nullopt;  // which a solve refuses
  progress.update(0, kWhat);
  const Averaged small = averagedPhotographs(photographs, tuning.across);
  std::optional<SensorNoise> told = toldNoise(capture, noise);
  if (told) told = SensorNoise{told->read / std::sqrt(small.each), told->fullWell * small.each};
  const CauseContext context = causeContext(capture, small.pixels, told);
  progress.update(.2F, kWhat);
  const MisfitCauses causes = misfitCauses(context.estimator, context.signal);
  if (causes.likely.empty() || causes.likely.front() != Cause::Field) return std::nullopt;

  DriftSample sample(context, tuning);
  LampDrift drift(capture.lightCount());
  for (int round = 0; round < tuning.rounds; ++round) {
    const auto now = [&](float part) {
      progress.update(.3F + .7F * (float(round) + part) / float(tuning.rounds), kWhat);
    };
    now(0);
    if (round > 0) sample.fit(drift);
    const DriftEvidence matte = matteEvidence(sample, tuning);
    now(.5F);
    const DriftEvidence surface = surfaceEvidence(sample, tuning);
    Eigen::MatrixXd information = matte.information + surface.information;
    const double known = 1 / (tuning.drift * tuning.drift);
    information.diagonal().array() += known;
    const Eigen::VectorXd pull = matte.pull + surface.pull - known * drift.unknowns();
    drift = LampDrift(capture.lightCount(), drift.unknowns() + solveSymmetric(information, pull));
  }
  return drift;
}

}  // namespace swaplight
