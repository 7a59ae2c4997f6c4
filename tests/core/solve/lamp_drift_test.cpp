#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "core/base/error.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/field/drift_evidence.h"
#include "core/solve/field/drift_fit.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

/// Two swapped gels without blue, and photographs that have next to none.
struct NoBlue {
  Capture capture = rotatedCapture(2);
  CapturePixels pixels;

  NoBlue() {
    capture.noise = SensorNoise{.002, 20000};
    pixels = photograph(capture, SyntheticSet(2, 0));
    for (Shot& shot : capture.shots)
      for (auto& color : shot.lightColors) color->b = 0;
    for (size_t k = 0; k < pixels.shots.size(); ++k)
      for (size_t p = 0; p < pixels.shots[k].pixelCount(); ++p)
        pixels.shots[k].plane(2)[p] = .002F * std::sin(float(7 * p + k));
  }
};

TEST(LampDriftEvidence, OfMatteSurfacesIsThereWithoutAChannel) {
  const NoBlue set;
  const CauseContext context = causeContext(set.capture, set.pixels, set.capture.noise);
  const FieldTuning tuning;
  const DriftEvidence matte = matteEvidence(DriftSample(context, tuning), tuning);
  EXPECT_GT(matte.information.norm(), 1);
  EXPECT_TRUE(matte.information.allFinite() && matte.pull.allFinite());
}

TEST(LampDrift, IsLookedForUntilAskedToStop) {
  const NoBlue set;
  const std::atomic<bool> stop = true;
  Progress progress;
  progress.stop = &stop;
  EXPECT_THROW((void)findDrift(set.capture, set.pixels, {}, progress), Stopped);
}

}  // namespace
}  // namespace swaplight
