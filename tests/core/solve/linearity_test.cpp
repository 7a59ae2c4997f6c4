#include "core/solve/causes/linearity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>

#include "core/base/json.h"
#include "core/solve/model/pixel_run.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

using Answer = LinearityEvidence::Answer;
using Curve = std::function<double(double)>;
constexpr SensorNoise kCamera{.001, 50000};
constexpr int kColumns = 160, kRows = 120;

double light(double y) {
  return y;
}
double contrast(double y) {
  const double v = std::pow(std::max(y, 0.0), 1 / 2.2);
  return std::pow(v + .3 * (3 * v * v - 2 * v * v * v - v), 2.2);
}

/// What a lamp gives of a place: a surface that is not matte, which has another colour for each lamp.
double contribution(int lamp, int channel, int x, int y) {
  const double u = double(x) / kColumns, v = double(y) / kRows;
  const double surface =
      .5 + .45 * std::sin(9 * u + 3 * lamp + 2 * channel) * std::cos(7 * v + channel - lamp);
  return .45 * surface * (lamp == 0 ? 1.1 - u : .1 + u);
}

/// Photographs under `colors` [shot][lamp] and `stops`, with a curve on the light and what no lamp gives.
CapturePixels photographs(const Capture& capture, const Curve& curve, double ambient = 0) {
  std::mt19937 random(7);
  std::normal_distribution<double> gauss;
  CapturePixels pixels;
  for (const Shot& shot : capture.shots) {
    Image image(ImageSpec::rgb(kColumns, kRows));
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < kRows; ++y)
        for (int x = 0; x < kColumns; ++x) {
          double sum = ambient * contribution(0, c, x, y);
          for (int i = 0; i < 2; ++i)
            sum += double((*shot.lightColors[size_t(i)])[c]) * contribution(i, c, x, y);
          sum *= std::exp2(double(shot.exposureStops));
          const double noisy =
              sum + gauss(random) * std::sqrt(sum / kCamera.fullWell + kCamera.read * kCamera.read);
          image.span().at(c, x, y) = float(curve(noisy));
        }
    pixels.shots.push_back(std::move(image));
    pixels.clipLevel.push_back(INFINITY);
    pixels.quantum.push_back(0);
  }
  return pixels;
}

Capture captureUnder(const std::vector<std::vector<Rgb>>& colors, const std::vector<float>& stops = {}) {
  Capture capture = rotatedCapture(2);
  capture.noise = kCamera;
  capture.shots.resize(colors.size());
  for (size_t k = 0; k < colors.size(); ++k) {
    capture.shots[k] = {};
    capture.shots[k].lightColors.assign(colors[k].begin(), colors[k].end());
    if (!stops.empty()) capture.shots[k].exposureStops = stops[k];
  }
  return capture;
}

Capture aloneAndTogether() {
  return captureUnder({{Rgb(1), Rgb(0)}, {Rgb(0), Rgb(1)}, {Rgb(1), Rgb(1)}});
}

TEST(Linearity, ByLampsAloneAndTogetherWhateverSurfacesAre) {
  const Capture capture = aloneAndTogether();
  const LinearityEvidence linear = linearityOf(capture, photographs(capture, light));
  EXPECT_EQ(linear.answer, Answer::Linear) << linear.words;
  const LinearityEvidence curved = linearityOf(capture, photographs(capture, contrast));
  ASSERT_EQ(curved.answer, Answer::Curved) << curved.words;
  EXPECT_THAT(curved.words, testing::HasSubstr("do not add up"));
  // The curve is the camera's, backwards, up to exposure.
  ASSERT_EQ(curved.curve.size(), 8U);
  const double level = contrast(double(curved.curve[5][1])) / double(curved.curve[5][0]);
  for (size_t k = 3; k < 7; ++k)
    EXPECT_NEAR(contrast(double(curved.curve[k][1])) / double(curved.curve[k][0]) / level, 1, .12) << k;
}

TEST(Linearity, ByBracketsUnderAmbientLight) {
  const std::vector<Rgb> first{{.9F, .2F, .15F}, {.15F, .8F, .25F}}, second{first[1], first[0]};
  const Capture capture = captureUnder({first, first, first, second, second, second}, {0, -2, -1, 0, -2, -1});
  Capture told = capture;  // gels that nobody measured: what they are like does not matter
  for (Shot& shot : told.shots)
    for (auto& color : shot.lightColors)
      if (*color == first[0]) color = Rgb(.6F, .5F, .1F);
  const LinearityEvidence linear = linearityOf(told, photographs(capture, light, .1));
  EXPECT_TRUE(linear.ambientProof);
  EXPECT_EQ(linear.answer, Answer::Linear) << linear.words;
  EXPECT_NEAR(linear.additivity->exponent, 1, 3 * linear.additivity->exponentError + .005);
  const LinearityEvidence curved = linearityOf(told, photographs(capture, contrast, .1));
  EXPECT_EQ(curved.answer, Answer::Curved) << jsonFromLinearity(curved).dump(1);
}

TEST(Linearity, TakesNoFlickerForACurve) {
  // Every pair of three gels, swapped: photographs that add up, but hardly show a curve.
  const Rgb a{.9F, .2F, .15F}, b{.15F, .8F, .25F}, c{1, 1, 1};
  const Capture capture = captureUnder({{a, b}, {b, a}, {a, c}, {c, a}, {b, c}, {c, b}});
  CapturePixels pixels = photographs(capture, light);
  for (int channel = 0; channel < 3; ++channel)
    for (size_t p = 0; p < pixels.shots[2].pixelCount(); ++p) pixels.shots[2].plane(channel)[p] *= 1.02F;
  const LinearityEvidence evidence = linearityOf(capture, pixels);
  EXPECT_FALSE(evidence.additivity.has_value());
  EXPECT_NE(evidence.answer, Answer::Curved) << jsonFromLinearity(evidence).dump(1);
}

TEST(Linearity, TakesNoFlickerOfSumsForACurve) {
  const Capture capture = aloneAndTogether();
  CapturePixels pixels = photographs(capture, light);
  for (int channel = 0; channel < 3; ++channel)
    for (size_t p = 0; p < pixels.shots[2].pixelCount(); ++p) pixels.shots[2].plane(channel)[p] *= 1.02F;
  EXPECT_NE(linearityOf(capture, pixels).answer, Answer::Curved);
}

TEST(Linearity, TakesTheCurveOffBeforeAmbientLight) {
  const Capture capture = aloneAndTogether();
  CapturePixels pixels = photographs(capture, contrast, .2);
  CapturePixels dark = photographs(captureUnder({{Rgb(0), Rgb(0)}}), contrast, .2);
  pixels.ambient = std::move(dark.shots.front());
  const LinearityEvidence curved = linearityOf(capture, pixels);
  ASSERT_EQ(curved.answer, Answer::Curved) << curved.words;
  const double level = contrast(double(curved.curve[5][1])) / double(curved.curve[5][0]);
  for (size_t k = 3; k < 7; ++k)
    EXPECT_NEAR(contrast(double(curved.curve[k][1])) / double(curved.curve[k][0]) / level, 1, .12) << k;
}

TEST(Linearity, UnknownGelsAreTheSameAsNoOther) {
  const std::vector<Rgb> first{{.9F, .2F, .15F}, {.15F, .8F, .25F}}, second{first[1], first[0]};
  const Capture told = captureUnder({first, first, second, second}, {0, -1, 0, -1});
  Capture unknown = told;
  for (size_t k = 0; k < 4; ++k)
    for (size_t i = 0; i < 2; ++i) {
      unknown.shots[k].lightColors[i].reset();
      unknown.shots[k].colorNames.resize(2);
      unknown.shots[k].colorNames[i] = (k < 2) == (i == 0) ? "?a" : "?b";
    }
  const LinearityEvidence linear = linearityOf(unknown, photographs(told, light));
  EXPECT_NE(linear.answer, Answer::Curved) << jsonFromLinearity(linear).dump(1);
}

TEST(Linearity, CannotTellAPowerOfLightFromOneLampAPhotograph) {
  // A matte set under one white lamp after the other is matte again under any power.
  const Capture capture = captureUnder({{Rgb(1), Rgb(0)}, {Rgb(0), Rgb(1)}});
  CapturePixels pixels = photographs(capture, light);
  for (size_t k = 0; k < 2; ++k)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < kRows; ++y)
        for (int x = 0; x < kColumns; ++x) {
          const double lamp = k == 0 ? 1.1 - double(x) / kColumns : .1 + double(x) / kColumns;
          const double paint = .5 + .4 * std::sin(.3 * x + c) * std::cos(.2 * y - c);
          pixels.shots[k].span().at(c, x, y) = float(std::pow(.6 * lamp * paint, 2.2));
        }
  const LinearityEvidence evidence = linearityOf(capture, pixels);
  EXPECT_EQ(evidence.answer, Answer::Unknown) << jsonFromLinearity(evidence).dump(1);
}

TEST(Linearity, SaysNothingOfMorePhotographsThanASolveTakes) {
  const Capture capture =
      captureUnder(std::vector<std::vector<Rgb>>(size_t(kMaxShots) + 1, std::vector<Rgb>{Rgb(1), Rgb(0)}));
  CapturePixels pixels;
  for (int k = 0; k < capture.shotCount(); ++k) {
    pixels.shots.emplace_back(ImageSpec::rgb(8, 8), .5F);
    pixels.clipLevel.push_back(INFINITY);
    pixels.quantum.push_back(0);
  }
  const LinearityEvidence evidence = linearityOf(capture, pixels);
  EXPECT_EQ(evidence.answer, Answer::Unknown);
  EXPECT_THAT(evidence.words, testing::HasSubstr("more than 32 photographs"));
}

TEST(Linearity, SaysWhatWouldTell) {
  Capture capture = captureUnder({{Rgb(1), Rgb(0)}, {Rgb(0), Rgb(1)}});
  const CapturePixels pixels = photographs(capture, light);
  capture.shots[0].lightColors[0].reset();
  const LinearityEvidence unknown = linearityOf(capture, pixels);
  EXPECT_EQ(unknown.answer, Answer::Unknown);
  EXPECT_THAT(unknown.words, testing::HasSubstr("colour is unknown"));
  EXPECT_TRUE(jsonFromLinearity(unknown)["linear"].is_null());
  EXPECT_TRUE(jsonFromLinearity(unknown)["additivity"].is_null());
}

TEST(Linearity, CanBeStopped) {
  const Capture capture = captureUnder({{Rgb(1), Rgb(0)}, {Rgb(0), Rgb(1)}, {Rgb(1), Rgb(1)}});
  const CapturePixels pixels = photographs(capture, light);
  int told = 0;
  std::atomic<bool> stop = false;
  Progress progress;
  progress.stop = &stop;
  progress.report = [&](float fraction, std::string_view) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    stop = ++told == 5;
  };
  EXPECT_THROW((void)linearityOf(capture, pixels, progress), Stopped);
  EXPECT_EQ(told, 5);
}

TEST(Linearity, SaysWhatToDoOnTheCommandLineOnly) {
  const Capture capture = captureUnder({{Rgb(1), Rgb(0)}, {Rgb(0), Rgb(1)}, {Rgb(1), Rgb(1)}});
  const LinearityEvidence curved = linearityOf(capture, photographs(capture, contrast));
  ASSERT_EQ(curved.answer, Answer::Curved);
  EXPECT_THAT(curved.words, testing::StartsWith(curved.finding));
  EXPECT_THAT(curved.words, testing::HasSubstr("--tone auto"));
  EXPECT_THAT(curved.finding, testing::Not(testing::HasSubstr("--")));
}

}  // namespace
}  // namespace swaplight
