#pragma once

#include "core/capture/capture_pixels.h"
#include "core/set/solved_set.h"
#include "core/solve/model/solve_options.h"

namespace swaplight {

/// What a capture's values have to be multiplied with so that they lie around 1, where solving is accurate
/// (its noise models and tolerances are in units of full scale). A power of two, so that nothing is rounded;
/// 1 for whatever is near enough. The level is the 95th percentile of the finite values: hot pixels do not
/// count. Throws InputError that begins with `where` for values that no light has (beyond 1e22, all below
/// 1e-30).
[[nodiscard]] float signalScale(const CapturePixels& pixels, const std::string& where);

/// The pictures times `scale`, and the sensor noise that they then have.
[[nodiscard]] CapturePixels scaledSignal(const CapturePixels& pixels, float scale);
[[nodiscard]] SensorNoise scaledNoise(const SensorNoise& noise, float scale);

/// The solution of scaled pictures as that of the pictures themselves.
void unscale(SolvedSet& set, float scale);

}  // namespace swaplight
