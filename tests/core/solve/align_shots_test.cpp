#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_shots.h"
#include "core/solve/registration/shot_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "core/capture/capture.h"
#include "core/image/io/image_io.h"
#include "core/solve/solve.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

/// A set that can be photographed from any fraction of a pixel: smooth blobs of albedo under two lights.
class MovableSet {
 public:
  static constexpr int kWidth = 160;
  static constexpr int kHeight = 128;

  MovableSet() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0, 1);
    for (int j = 0; j < 150; ++j)
      m_blobs.push_back({kWidth * (1.2F * unit(random) - 0.1F), kHeight * (1.2F * unit(random) - 0.1F),
                         2 + 4 * unit(random), 0.4F * unit(random), 0.4F * unit(random),
                         0.4F * unit(random)});
  }
  [[nodiscard]] float light(int i, int channel, float x, float y) const {
    float albedo = 0.1F;
    for (const auto& b : m_blobs) {
      const float d = ((x - b[0]) * (x - b[0]) + (y - b[1]) * (y - b[1])) / (2 * b[2] * b[2]);
      if (d < 9) albedo += b[3 + size_t(channel)] * std::exp(-d);
    }
    const float slope = 0.5F + 0.4F * std::sin(0.02F * x + 0.015F * y);
    return albedo * 0.5F * (i == 0 ? slope : 1 - slope);
  }
  [[nodiscard]] CapturePixels photograph(const Capture& capture, const std::vector<ShotShift>& shifts) const {
    std::mt19937 random(3);
    std::normal_distribution<float> gauss(0, 0.001F);
    CapturePixels pixels;
    for (size_t k = 0; k < capture.shots.size(); ++k) {
      Image image(ImageSpec::rgb(kWidth, kHeight));
      for (int c = 0; c < 3; ++c)
        for (int y = 0; y < kHeight; ++y)
          for (int x = 0; x < kWidth; ++x) {
            float sum = gauss(random);
            const auto [u, v] = shownAt(shifts[k], float(x), float(y));
            for (int i = 0; i < 2; ++i)
              sum += (*capture.shots[k].lightColors[size_t(i)])[c] * light(i, c, u, v);
            image.span().at(c, x, y) = sum;
          }
      pixels.shots.push_back(std::move(image));
      pixels.clipLevel.push_back(INFINITY);
      pixels.quantum.push_back(0);
    }
    return pixels;
  }
  [[nodiscard]] double relativeError(const SolvedSet& set) const {
    double error = 0;
    double power = 0;
    for (int i = 0; i < 2; ++i)
      for (int c = 0; c < 3; ++c)
        for (int y = 0; y < kHeight; ++y)
          for (int x = 0; x < kWidth; ++x) {
            const double t = light(i, c, float(x), float(y));
            const double d = set.contributions[size_t(i)].view().at(c, x, y) - t;
            error += d * d;
            power += t * t;
          }
    return std::sqrt(error / power);
  }

 private:
  /// The place of the set that a moved camera sees at a pixel.
  static std::array<float, 2> shownAt(const ShotShift& shift, float x, float y) {
    const float middleX = (kWidth - 1) / 2.0F, middleY = (kHeight - 1) / 2.0F;
    const float right = (x - middleX - shift.x) / shift.zoom, down = (y - middleY - shift.y) / shift.zoom;
    return {middleX + std::cos(shift.turn) * right + std::sin(shift.turn) * down,
            middleY - std::sin(shift.turn) * right + std::cos(shift.turn) * down};
  }

  std::vector<std::array<float, 6>> m_blobs;
};

Capture swappedLights() {
  Capture capture = rotatedCapture(2);
  capture.noise = SensorNoise{.001, 1e9};
  return capture;
}

TEST(AlignShots, AShiftIsMeasuredToAFewHundredthsOfAPixelThoughTheLightsChange) {
  const Capture capture = swappedLights();
  const MovableSet set;
  for (const ShotShift shift :
       {ShotShift{0, 0}, ShotShift{0.5F, -0.3F}, ShotShift{-2.4F, 1.7F}, ShotShift{7, 3}}) {
    const auto found = measureShifts(set.photograph(capture, {{0, 0}, shift}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(found[1].found);
    EXPECT_NEAR(found[1].x, shift.x, 0.08);
    EXPECT_NEAR(found[1].y, shift.y, 0.08);
    printf("shift %.2f %.2f measured %.3f %.3f\n", shift.x, shift.y, found[1].x, found[1].y);
  }
}

ShotShift turned(float x, float y, float degrees, float zoom) {
  ShotShift shift{x, y};
  shift.turn = degrees * float(M_PI) / 180;
  shift.zoom = zoom;
  return shift;
}

TEST(AlignShots, ATurnAndAZoomAreMeasuredToAThirdOfAPixelAtTheCorners) {
  const Capture capture = swappedLights();
  const MovableSet set;
  for (const ShotShift& shift : {turned(0, 0, 1, 1), turned(.7F, -1.2F, -1.5F, 1), turned(0, 0, 0, 1.015F),
                                 turned(-2.3F, .4F, 2, .985F)}) {
    const auto found = measureShifts(set.photograph(capture, {{0, 0}, shift}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_TRUE(worthMoving(found[1]));
    EXPECT_TRUE(found[1].isTurned());
    const ShotPlaces places(found[1], MovableSet::kWidth, MovableSet::kHeight);
    const ShotPlaces truth(shift, MovableSet::kWidth, MovableSet::kHeight);
    for (const float u : {0.0F, MovableSet::kWidth - 1.0F})
      for (const float v : {0.0F, MovableSet::kHeight - 1.0F}) {
        EXPECT_NEAR(places(u, v).x, truth(u, v).x, .33) << shift.turn << " " << shift.zoom;
        EXPECT_NEAR(places(u, v).y, truth(u, v).y, .33) << shift.turn << " " << shift.zoom;
      }
    EXPECT_NEAR(farthestMove(found, MovableSet::kWidth, MovableSet::kHeight), truth.farthestMove(), .33);
  }
}

TEST(AlignShots, ATurnedShotIsSolvedNearlyAsWellAsOneThatStoodStill) {
  const Capture capture = swappedLights();
  const MovableSet set;
  const CapturePixels pixels = set.photograph(capture, {{0, 0}, turned(.4F, .9F, 1.2F, 1.006F)});
  SolveOptions options;
  options.align = Remedy::Off;
  const double still = set.relativeError(solve(capture, set.photograph(capture, {{0, 0}, {0, 0}}), options));
  const double without = set.relativeError(solve(capture, pixels, options));
  options.align = Remedy::On;
  const SolvedSet solved = solve(capture, pixels, options);
  printf("still %.4f turned %.4f aligned %.4f\n", still, without, set.relativeError(solved));
  EXPECT_LT(set.relativeError(solved), .3 * without);
  EXPECT_LT(set.relativeError(solved), 1.2 * still);
  EXPECT_TRUE(solved.report->shifts[1].isTurned());
  EXPECT_NE(solved.report->message.find("turned"), std::string::npos);
}

TEST(AlignShots, LightsFromOtherSidesAreNotTakenForAMovedCameraButHalfAPixelIs) {
  const std::filesystem::path samples = SWAPLIGHT_SAMPLES;
  for (const char* name : {"three_point", "film_set", "two_swapped"}) {
    std::vector<std::filesystem::path> files;  // one light each, of a set that stands still
    for (const auto& entry : std::filesystem::directory_iterator(samples / name / "truth"))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    float farthest = 0;
    for (size_t first = 0; first < files.size(); ++first) {
      std::rotate(files.begin(), files.begin() + 1, files.end());
      CapturePixels pixels;
      for (const auto& file : files) {
        pixels.shots.push_back(readImage(file).image);
        pixels.clipLevel.push_back(INFINITY);
        pixels.quantum.push_back(0);
      }
      for (const ShotShift& shift : measureShifts(pixels)) {
        farthest = std::max(farthest, std::hypot(shift.x, shift.y));
        EXPECT_FALSE(worthMoving(shift)) << name << " " << shift.x << " " << shift.y;
      }
    }
    EXPECT_GT(farthest, 0.15F) << "the whole pictures alone would have it move";
  }
  for (const char* name : {"three_point", "film_set", "two_swapped"}) {
    const CapturePixels still = loadCapturePixels(
        test::builtinColors(), readCapture(test::builtinColors(), samples / name / "capture.json"));
    for (const ShotShift half : {ShotShift{0.5F, 0}, ShotShift{0, -0.5F}, ShotShift{-0.35F, 0.35F}}) {
      std::vector<ShotShift> shifts(still.shots.size());
      shifts[1] = half;
      const std::vector<ShotShift> found = measureShifts(movedShots(still, shifts));
      for (size_t k = 0; k < found.size(); ++k)
        EXPECT_EQ(worthMoving(found[k]), k == 1) << name << " " << found[k].x << " " << found[k].y;
    }
  }
}

TEST(AlignShots, ASolveOfAMovedShotIsNearlyAsGoodAsIfItHadNotMoved) {
  const Capture capture = swappedLights();
  const MovableSet set;
  SolveOptions plain;
  plain.align = Remedy::Off;
  SolveOptions align;
  align.align = Remedy::On;
  const CapturePixels moved = set.photograph(capture, {{0, 0}, {1.3F, -0.6F}});
  const double still = set.relativeError(solve(capture, set.photograph(capture, {{0, 0}, {0, 0}}), plain));
  const double without = set.relativeError(solve(capture, moved, plain));
  const SolvedSet solved = solve(capture, moved, align);
  printf("still %.4f moved %.4f aligned %.4f\n", still, without, set.relativeError(solved));
  EXPECT_LT(set.relativeError(solved), 0.5 * without);
  ASSERT_EQ(solved.report->shifts.size(), 2U);
  EXPECT_NEAR(double(solved.report->shifts[1].x), 1.3, 0.08);
  // What the second shot does not show is said.
  EXPECT_TRUE(int(solved.quality.view().at(kFlags, MovableSet::kWidth - 1, 60)) & kFilled);
  EXPECT_FALSE(int(solved.quality.view().at(kFlags, 80, 60)) & kFilled);
}

TEST(AlignShots, ACameraThatSurelyMovedIsAlignedUnasked) {
  const Capture capture = swappedLights();
  const MovableSet set;
  const auto solved = [&](const ShotShift& shift) {
    return solve(capture, set.photograph(capture, {{0, 0}, shift}), {});
  };
  const SolvedSet moved = solved({1.3F, -0.6F});
  ASSERT_EQ(moved.report->shifts.size(), 2U);
  EXPECT_NEAR(double(moved.report->shifts[1].x), 1.3, 0.08);
  ASSERT_FALSE(moved.report->warnings.empty());
  EXPECT_NE(moved.report->warnings.front().find("--align off"), std::string::npos);
  EXPECT_TRUE(moved.report->causes.likely.empty()) << "nothing is wrong any more";
  // So far that what it leaves looks like no small shift.
  const SolvedSet far = solved({7, 3});
  ASSERT_EQ(far.report->shifts.size(), 2U);
  EXPECT_NEAR(double(far.report->shifts[1].x), 7, 0.08);
  EXPECT_NE(far.report->warnings.front().find("--align off"), std::string::npos);
  SolveOptions asked;
  asked.align = Remedy::On;
  const SolvedSet asAsked = solve(capture, set.photograph(capture, {{0, 0}, {7, 3}}), asked);
  EXPECT_NEAR(set.relativeError(far), set.relativeError(asAsked), 1e-6);

  const SolvedSet still = solved({});
  EXPECT_TRUE(still.report->shifts.empty());
  EXPECT_TRUE(still.report->warnings.empty());
}

TEST(AlignShots, AShotOfSomethingElseIsLeftWhereItIsAndNamed) {
  const Capture capture = swappedLights();
  CapturePixels pixels = MovableSet().photograph(capture, {{0, 0}, {0, 0}});
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < pixels.shots[1].pixelCount(); ++p) pixels.shots[1].plane(c)[p] = unit(random);
  SolveOptions options;
  options.align = Remedy::On;
  const SolvedSet set = solve(capture, pixels, options);
  EXPECT_FALSE(set.report->shifts[1].found);
  ASSERT_FALSE(set.report->warnings.empty());
  EXPECT_NE(set.report->warnings[0].find("shot 2"), std::string::npos);
  const auto aboutAligning = [&](const SolveOptions& asked, const std::string& file) {
    Capture named = capture;
    named.shots[1].image = file;
    const SolvedSet solved = solve(named, pixels, asked);
    return std::ranges::count_if(solved.report->warnings, [](const std::string& warning) {
      return warning.find("could not be aligned") != std::string::npos &&
             warning.find("(door.exr)") != std::string::npos;
    });
  };
  EXPECT_EQ(aboutAligning(options, "door.exr"), 1);
  EXPECT_EQ(aboutAligning({}, "door.exr"), 0) << "nobody asked for aligning";
}

TEST(AlignShots, SaturatedAndBrokenValuesStaySoWhenAShotMoves) {
  CapturePixels pixels;
  for (int k = 0; k < 2; ++k) {
    pixels.shots.emplace_back(ImageSpec::rgb(16, 16), 0.5F);
    pixels.clipLevel.push_back(0.99F);
    pixels.quantum.push_back(0);
  }
  pixels.shots[1].span().at(0, 8, 8) = 1;
  pixels.shots[1].span().at(1, 8, 8) = NAN;
  const CapturePixels moved = movedShots(pixels, {{0, 0}, {1.5F, 0}});
  EXPECT_GE(moved.shots[1].view().at(0, 6, 8), 0.99F);
  EXPECT_GE(moved.shots[1].view().at(0, 7, 8), 0.99F);
  EXPECT_TRUE(std::isnan(moved.shots[1].view().at(1, 7, 8)));
  EXPECT_NEAR(moved.shots[1].view().at(2, 7, 8), 0.5F, 1e-6);
  EXPECT_LT(moved.shots[1].view().at(0, 2, 8), 0.6F);

  const CapturePixels turnedShots = movedShots(pixels, {{0, 0}, turned(0, 0, 10, 1)});
  const ImageView view = turnedShots.shots[1].view();
  EXPECT_GE(*std::max_element(view.row(0, 0), view.row(0, 0) + 256), 0.99F);
  EXPECT_TRUE(
      std::any_of(view.row(1, 0), view.row(1, 0) + 256, [](float value) { return std::isnan(value); }));
  for (int x = 0; x < 16; ++x) EXPECT_NEAR(view.at(2, x, 5), 0.5F, 1e-5);
}

}  // namespace
}  // namespace swaplight
