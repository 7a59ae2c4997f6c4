#include "core/solve/estimators/gloss_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

double relativeError(const SolvedSet& set, const SyntheticSet& truth) {
  double error = 0;
  double power = 0;
  for (size_t i = 0; i < truth.truth.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < truth.truth[i].pixelCount(); ++p) {
        const double t = truth.truth[i].plane(c)[p];
        error += std::pow(double(set.contributions[i].plane(c)[p]) - t, 2);
        power += t * t;
      }
  return std::sqrt(error / power);
}

SolveOptions using_(Model model) {
  SolveOptions options;
  options.model = model;
  return options;
}

TEST(GlossFit, MatteSurfacesWithWhiteHighlightsAreNearlyExactWithoutNoise) {
  for (int lights : {2, 3, 4, 5}) {
    const SyntheticSet truth(lights, .4F);
    Capture capture = rotatedCapture(lights);
    capture.noise = SensorNoise{1e-5, 1e9};
    const CapturePixels pixels = photograph(capture, truth);
    const double gloss = relativeError(solve(capture, pixels, using_(Model::Gloss)), truth);
    const double matte = relativeError(solve(capture, pixels, using_(Model::Lambert)), truth);
    EXPECT_LT(gloss, .03) << lights;
    EXPECT_LT(gloss, .4 * matte) << lights;
  }
}

TEST(GlossFit, BeatsBothNeighboursOnTheLadderWhereThereAreHighlightsAndNoise) {
  const SyntheticSet truth(3, .4F);
  Capture capture = rotatedCapture(3);
  capture.noise = SensorNoise{.004, 5000};
  const CapturePixels pixels = photograph(capture, truth);
  const double gloss = relativeError(solve(capture, pixels, using_(Model::Gloss)), truth);
  EXPECT_LT(gloss, relativeError(solve(capture, pixels, using_(Model::Lambert)), truth));
  EXPECT_LT(gloss, relativeError(solve(capture, pixels, using_(Model::Transport)), truth));
}

TEST(GlossFit, IsScaledWithTheLight) {
  const SyntheticSet truth(2, .4F);
  Capture capture = rotatedCapture(2);
  capture.noise = SensorNoise{.002, 20000};
  const CapturePixels pixels = photograph(capture, truth);
  CapturePixels brighter = photograph(capture, truth);
  for (Image& shot : brighter.shots)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < shot.pixelCount(); ++p) shot.plane(c)[p] *= 4;
  Capture scaled = capture;
  scaled.noise = SensorNoise{.008, 5000};  // of four times the signal
  const SolvedSet once = solve(capture, pixels, using_(Model::Gloss));
  const SolvedSet fourTimes = solve(scaled, brighter, using_(Model::Gloss));
  for (size_t p = 0; p < once.beta.pixelCount(); ++p)
    ASSERT_NEAR(fourTimes.contributions[0].plane(1)[p], 4 * once.contributions[0].plane(1)[p],
                .02 + .02 * fourTimes.contributions[0].plane(1)[p]);
}

TEST(GlossFit, SaysHowManyShotsItNeeds) {
  EstimatorContext context{lightingFromCapture(rotatedCapture(8)), {}};
  context.lighting.shots = 5;
  context.lighting.colors.resize(40);
  EXPECT_THROW(GlossFit{context}, InputError);
  context = {lightingFromCapture(rotatedCapture(2)), {}};
  EXPECT_NO_THROW(GlossFit{context});
}

}  // namespace
}  // namespace swaplight
