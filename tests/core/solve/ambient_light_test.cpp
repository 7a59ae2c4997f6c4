#include "core/solve/calibration/ambient_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/image/cropped_image.h"
#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

const Rgb kBluish(.6F, 1.0F, 1.4F);

/// Two lights, swapped and then dimmed, and a bluish ambient light: one more light that is never changed.
struct Room {
  SyntheticSet set{3, 0};
  Capture capture = rotatedCapture(2);
  CapturePixels pixels;

  explicit Room(const Rgb& ambientColor) {
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.truth[2].pixelCount(); ++p)
        set.truth[2].plane(c)[p] *= .3F * ambientColor[c];
    capture.shots.push_back(capture.shots.front());
    for (auto& color : capture.shots.back().lightColors) *color *= .2F;
    capture.shots[1].exposureStops = 1;
    Capture lit = capture;
    for (Shot& shot : lit.shots) shot.lightColors.emplace_back(Rgb(1));
    pixels = photograph(lit, set);
  }
};

double relativeError(const Image& test, const Image& truth) {
  double error = 0;
  double power = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < truth.pixelCount(); ++p) {
      error += std::pow(double(test.plane(c)[p]) - truth.plane(c)[p], 2);
      power += std::pow(double(truth.plane(c)[p]), 2);
    }
  return std::sqrt(error / power);
}

TEST(AmbientLight, IsFoundWithTheLightsFromOneMoreShot) {
  const Room room(kBluish);
  for (const Model model : {Model::Lambert, Model::Transport, Model::Auto}) {
    SolveOptions options;
    options.model = model;
    options.solveAmbient = true;
    options.noise = SensorNoise{1e-4, 1e7};
    const SolvedSet set = solve(room.capture, room.pixels, options);
    SCOPED_TRACE(modelName(model));
    ASSERT_EQ(set.lightCount(), 2);
    ASSERT_TRUE(set.ambient);
    EXPECT_EQ(set.capture.lightCount(), 2);
    for (size_t i = 0; i < 2; ++i) EXPECT_LT(relativeError(set.contributions[i], room.set.truth[i]), .01);
    EXPECT_LT(relativeError(*set.ambient, room.set.truth[2]), .02);
    for (size_t p = 0; p < set.beta.pixelCount(); ++p)
      ASSERT_NEAR(set.beta.plane(0)[p] + set.beta.plane(1)[p], 1, 1e-5) << "of the lights alone";
  }
}

TEST(AmbientLight, NotAskedForSpoilsTheLights) {
  const Room room(kBluish);
  const SolvedSet set = solve(room.capture, room.pixels, {});
  EXPECT_FALSE(set.ambient);
  EXPECT_GT(relativeError(set.contributions[0], room.set.truth[0]), .05);
}

TEST(AmbientLight, ThatIsNotThereStaysDark) {
  Room room(Rgb(0));
  SolveOptions options;
  options.solveAmbient = true;
  options.noise = SensorNoise{1e-4, 1e7};
  const SolvedSet set = solve(room.capture, room.pixels, options);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < set.ambient->pixelCount(); ++p) ASSERT_LT(set.ambient->plane(c)[p], .01);
}

TEST(AmbientLight, IsSoughtInPicturesOfAFewPixels) {
  const Room room(kBluish);
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {2, 2}, {5, 3}}) {
    CapturePixels few = withoutShots(room.pixels);
    for (const Image& shot : room.pixels.shots)
      few.shots.push_back(croppedImage(shot, {3, 2, width, height}, "shot"));
    SolveOptions options;
    options.solveAmbient = true;
    const SolvedSet set = solve(room.capture, few, options);
    ASSERT_TRUE(set.ambient);
    for (const Image& light : set.contributions)
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < light.pixelCount(); ++p) EXPECT_TRUE(std::isfinite(light.plane(c)[p]));
  }
}

TEST(AmbientLight, NeedsMoreShotsThanLightsAndNoPictureOfItsOwn) {
  Room room(kBluish);
  SolveOptions options;
  options.solveAmbient = true;
  Capture tooFew = room.capture;
  tooFew.shots.pop_back();
  CapturePixels twoShots = photograph(tooFew, SyntheticSet(2, 0));
  EXPECT_THROW((void)solve(tooFew, twoShots, options), InputError);
  room.capture.ambient = "ambient.exr";
  EXPECT_THROW((void)solve(room.capture, room.pixels, options), InputError);
}

}  // namespace
}  // namespace swaplight
