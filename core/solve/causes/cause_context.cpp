#include "core/solve/causes/cause_context.h"

#include <cmath>

#include "core/solve/calibration/residual_noise.h"

namespace swaplight {

std::optional<SensorNoise> toldNoise(const Capture& capture, const std::optional<SensorNoise>& asked) {
  if (asked) return asked;
  return capture.noise ? noiseInFrame(capture) : std::nullopt;
}

CauseContext causeContext(const Capture& capture, const CapturePixels& photographs,
                          const std::optional<SensorNoise>& told) {
  EstimatorContext context{lightingFromCapture(capture), {}};
  context.noise = noiseModel(told ? *told : estimateSensorNoise(photographs), photographs, 0);
  std::vector<float> exposure;
  for (const Shot& shot : capture.shots) exposure.push_back(std::exp2(shot.exposureStops));
  const ShotSignal signal(photographs, context.lighting, context.noise, exposure);
  if (!told) context.noise = residualNoise(context, codingNoise(photographs), signal);
  return {std::move(context), signal};
}

}  // namespace swaplight
