#include "core/solve/pixel_flags.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/capture/lightings.h"
#include "core/set/fill.h"
#include "core/solve/model/pixel_run.h"
#include "core/solve/registration/align_shots.h"

namespace swaplight {
namespace {

/// Whether a channel is clipped in a shot and in all others of its light: of a bracket, in every exposure.
bool clippedInALighting(const CapturePixels& pixels, const std::vector<int>& lightings, size_t pixel) {
  for (int c = 0; c < 3; ++c) {
    std::array<bool, kMaxShots> seen{};
    for (size_t k = 0; k < pixels.shots.size(); ++k)
      if (pixels.shots[k].plane(c)[pixel] < pixels.clipLevel[k]) seen[size_t(lightings[k])] = true;
    for (const int lighting : lightings)
      if (!seen[size_t(lighting)]) return true;
  }
  return false;
}

}  // namespace

std::vector<uint8_t> writeFlags(const CapturePixels& pixels, const ShotSignal& signal, float tooDarkSigma,
                                SolvedSet& set) {
  float* flags = set.quality.plane(kFlags);
  const float* sigma = set.quality.plane(kSigma);
  std::vector<uint8_t> unknown;
  const std::vector<int> lightings = lightingsOf(set.capture.shots);
  for (size_t p = 0; p < signal.pixelCount(); ++p) {
    int bits = int(flags[p]) | (signal.flags().empty() ? 0 : signal.flags()[p]);
    if (bits & kClipped && !clippedInALighting(pixels, lightings, p)) bits &= ~kClipped;
    if (sigma[p] > tooDarkSigma) bits |= kTooDark;
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

}  // namespace swaplight
