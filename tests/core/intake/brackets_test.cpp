#include "core/intake/brackets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/intake/capture_draft.h"
#include "core/intake/rotation_guess.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// Rotated gels, every lighting at these exposures.
Capture bracketed(int lights, const std::vector<float>& stops) {
  const Capture plain = rotatedCapture(lights);
  Capture capture = plain;
  capture.shots.clear();
  for (const Shot& lighting : plain.shots)
    for (const float one : stops) {
      capture.shots.push_back(lighting);
      capture.shots.back().exposureStops = one;
    }
  capture.noise = SensorNoise{.002, 20000};
  return capture;
}

/// Surfaces of some pixels: of single ones a camera would see the mean.
SyntheticSet patches(int lights) {
  SyntheticSet set(lights, 0);
  for (Image& light : set.truth)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < set.height; ++y)
        for (int x = 0; x < set.width; ++x) light.span().at(c, x, y) = light.view().at(c, x & ~3, y & ~3);
  return set;
}

/// As a camera gives it: clipped at full scale, in 255 steps after `curve`, and called linear.
CapturePixels photographed(
    const Capture& capture, float (*curve)(float) = [](float y) { return y; }) {
  CapturePixels pixels = photograph(capture, patches(capture.lightCount()));
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < pixels.shots[k].pixelCount(); ++p) {
        float& y = pixels.shots[k].plane(c)[p];
        y = std::round(255 * curve(std::clamp(y, 0.0F, 1.0F))) / 255;
      }
    pixels.clipLevel[k] = 0.999F;
  }
  return pixels;
}

ShotFolder folderOf(size_t shots, const std::vector<double>& stated = {}) {
  ShotFolder folder;
  folder.folder = "/set";
  for (size_t k = 0; k < shots; ++k) {
    folder.shots.push_back({fmt::format("{}.exr", k + 1), "", "lin_rec709", "openexr", 128, 64, {}});
    if (!stated.empty()) folder.shots.back().exposureStops = stated[k % stated.size()];
  }
  return folder;
}

TEST(Brackets, AreToldForOneBracketOrForEveryPhotograph) {
  const Brackets one = toldBrackets(folderOf(6), "0,-3, +2");
  EXPECT_EQ(one.length, 3);
  EXPECT_THAT(one.stops, ElementsAre(0, -3, 2, 0, -3, 2));
  EXPECT_EQ(one.lightingOf(2), 0U);
  EXPECT_EQ(one.lightingOf(3), 1U);
  EXPECT_EQ(exposureList(one), "0, -3, +2");
  EXPECT_EQ(toldBrackets(folderOf(4), "1,-1,1,-1").length, 2);
  EXPECT_THAT(toldBrackets(folderOf(4), "1,-1,1,-1").stops, ElementsAre(0, -2, 0, -2));
  EXPECT_EQ(toldBrackets(folderOf(4), "0").length, 1);
  EXPECT_EQ(toldBrackets(folderOf(4), "0,1,2,3").length, 1) << "nothing repeats itself";
}

TEST(Brackets, WhatIsToldMustFit) {
  const auto tell = [](const char* exposures) {
    return [=] { static_cast<void>(toldBrackets(folderOf(4), exposures)); };
  };
  EXPECT_THAT(tell("0,-3,+2"), ThrowsMessage<InputError>(HasSubstr("3 of them for 4 photographs")));
  for (const char* nonsense : {"0,much", "1e9", "nan", "0,,1", ""})
    EXPECT_THROW(tell(nonsense)(), InputError) << nonsense;
}

TEST(Brackets, AreFoundByTheRatiosOfThePhotographs) {
  for (const std::vector<float>& stops :
       {std::vector<float>{0, -3, 2}, std::vector<float>{0, -2}, std::vector<float>{-1, 0, 1, 2}}) {
    const Capture capture = bracketed(2, stops);
    const Brackets found = findBrackets(folderOf(capture.shots.size()), photographed(capture));
    ASSERT_EQ(found.length, static_cast<int>(stops.size()));
    for (size_t k = 0; k < found.stops.size(); ++k)
      EXPECT_NEAR(found.stops[k], stops[k % stops.size()] - stops[0], 0.03) << k;
    EXPECT_THAT(found.words, HasSubstr("by the ratios of the photographs"));
  }
}

TEST(Brackets, GelsThatChangePlacesAreNone) {
  for (const int lights : {2, 4}) {
    const Capture capture = rotatedCapture(lights);
    EXPECT_EQ(findBrackets(folderOf(capture.shots.size()), photographed(capture)).length, 1);
    // Nor where the files state what would repeat itself: it was dimmed to suit each lighting.
    const Brackets stated = findBrackets(folderOf(capture.shots.size(), {0, -1}), photographed(capture));
    EXPECT_EQ(stated.length, 1);
    EXPECT_THAT(stated.stops, IsEmpty());
  }
}

TEST(Brackets, MeasureWhatAShutterReallyDid) {
  const Capture capture = bracketed(2, {0, -3.09F});
  const Brackets found = findBrackets(folderOf(4, {0, -3}), photographed(capture));
  EXPECT_THAT(found.stops,
              ElementsAre(0, FloatNear(-3.09F, 0.02F), FloatNear(0, 0.02F), FloatNear(-3.09F, 0.02F)));
  const ShotFolder folder = folderOf(4);
  EXPECT_THAT(bracketWarnings(folder, photographed(capture), toldBrackets(folder, "0,-3")),
              Contains(HasSubstr("stops, not -3.00")));
  EXPECT_THAT(bracketWarnings(folder, photographed(capture), found), IsEmpty());
}

TEST(Brackets, SayWhereThePhotographsAreNotLinear) {
  const Capture capture = bracketed(2, {0, 2});
  const auto s = [](float y) { return y * y * (3 - 2 * y); };
  const CapturePixels bent = photographed(capture, s);
  const Brackets found = findBrackets(folderOf(4, {0, 2}), bent);
  ASSERT_EQ(found.length, 2) << "one lighting's photographs are a function of each other";
  EXPECT_FLOAT_EQ(found.stops[1], 2) << "measured with a wrong curve it would be another";
  EXPECT_THAT(bracketWarnings(folderOf(4), bent, found), Contains(HasSubstr("do not hold light as")));
  // A power makes the same of all brightnesses: it is told from an exposure only by what the files say.
  const CapturePixels power = photographed(capture, [](float y) { return std::pow(y, 1 / 2.2F); });
  EXPECT_THAT(bracketWarnings(folderOf(4), power, findBrackets(folderOf(4, {0, 2}), power)),
              Contains(HasSubstr("their colour space, is wrong")));
}

CaptureDraft draftFor(const Capture& capture, const Brackets& brackets) {
  std::vector<std::string> names;
  for (const Light& light : capture.lights) names.push_back(light.name);
  CaptureDraft draft = draftOf(folderOf(capture.shots.size()), names);
  setBrackets(draft, brackets);
  return draft;
}

TEST(Brackets, OnlyWhatNoExposureShowsIsClipped) {
  const Capture capture = bracketed(2, {0, 3});
  const CapturePixels pixels = photographed(capture);
  const ShotFolder folder = folderOf(4);
  const auto warningsOf = [&](const char* told) {
    return pictureWarnings(draftFor(capture, toldBrackets(folder, told)), pixels);
  };
  EXPECT_THAT(warningsOf("0"), Contains(HasSubstr("is clipped: expose less")));
  EXPECT_THAT(warningsOf("0,3"), Not(Contains(HasSubstr("clipped"))));
  const Capture longer = bracketed(2, {2, 3});
  EXPECT_THAT(pictureWarnings(draftFor(longer, toldBrackets(folder, "2,3")), photographed(longer)),
              Contains(HasSubstr("is clipped in all 2 exposures: add a shorter one")));
}

TEST(PictureWarnings, DarkPhotographsAreTold) {
  const Capture capture = bracketed(2, {0});
  const ShotFolder folder = folderOf(2);
  CapturePixels pixels = photographed(capture);
  const auto warnings = [&] { return pictureWarnings(draftFor(capture, toldBrackets(folder, "0")), pixels); };
  EXPECT_THAT(warnings(), Not(Contains(HasSubstr("stops below"))));
  for (Image& shot : pixels.shots)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < shot.pixelCount(); ++p) shot.plane(c)[p] *= .02F;
  EXPECT_THAT(warnings(), Contains(HasSubstr("expose up to")));
}

TEST(Brackets, HaveOneLightingsColours) {
  const Capture capture = bracketed(3, {0, -2});
  CaptureDraft draft = draftFor(capture, toldBrackets(folderOf(6), "0,-2"));
  const Capture unknown = captureOf(draft);
  EXPECT_EQ(unknown.shots[0].colorName(1), unknown.shots[1].colorName(1));
  EXPECT_NE(unknown.shots[0].colorName(1), unknown.shots[2].colorName(1));
  std::vector<ShotColor> ring;
  for (int i = 0; i < 3; ++i) ring.push_back(shotColorFromRgb(defaultColors()[static_cast<size_t>(i)]));
  const RotationGuess guess = guessRotation(draft, photographed(capture), ring);
  EXPECT_THAT(guess.steps, ElementsAre(0, 1, 2)) << guess.words;
  const Capture described = captureOf(withRotation(draft, ring, guess.steps));
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(described.shots[k].lightColors[0]->r, capture.shots[k].lightColors[0]->r);
    EXPECT_EQ(described.shots[k].exposureStops, capture.shots[k].exposureStops);
  }
}

TEST(Brackets, ACardIsReadOverItsExposureWithoutBracketsToo) {
  CapturePixels pixels = photographed(bracketed(2, {0}));
  for (size_t k = 0; k < 2; ++k)
    for (int c = 0; c < 3; ++c)
      std::fill_n(pixels.shots[k].plane(c), pixels.shots[k].pixelCount(), k == 0 ? 0.2F : 0.4F);
  CaptureDraft draft =
      draftOf(folderOf(2, {0, 1}), {"key", "fill"});  // the second photograph took twice as long
  for (size_t k = 0; k < 2; ++k) EXPECT_NEAR(colorOfCard(draft, pixels, k, 20, 20).color->g, 0.2F, 1e-3) << k;
  EXPECT_EQ(captureOf(draft).shots[1].exposureStops, 1) << "by which the solve multiplies the colour";
}

TEST(Brackets, ACardIsReadWhereItIsNotClipped) {
  Capture capture = bracketed(2, {0, 2});
  CapturePixels pixels = photographed(capture);
  for (size_t k = 0; k < 2; ++k)
    for (int c = 0; c < 3; ++c)
      std::fill_n(pixels.shots[k].plane(c), pixels.shots[k].pixelCount(),
                  std::min(1.0F, (c == 0 ? 0.6F : 0.2F) * (k == 0 ? 1.0F : 4.0F)));
  const ShotColor card = colorOfCard(draftFor(capture, toldBrackets(folderOf(4), "0,2")), pixels, 0, 20, 20);
  EXPECT_NEAR(card.color->r, 0.6F, 1e-3);
  EXPECT_NEAR(card.color->g, 0.2F, 1e-3);
}

}  // namespace
}  // namespace swaplight
