#include "core/solve/model/unknown_color.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/color/chromaticity.h"
#include "core/solve/calibration/swapped_color.h"
#include "core/solve/solve.h"
#include "core/solve/solve_photographs.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kWide = 128, kHigh = 64;
constexpr int kAloneX = 3, kGreyX = 11, kPlaceY = 60;
constexpr const char* kName = "?a";

/// Surfaces of random colours; from left to right beta of the first light rises from `least` to 1 - `least`,
/// and stays there a while. Bottom left are two places of 6 x 5 pixels: one that light 0 alone lights (too
/// small to be seen by itself), and one that is grey.
SyntheticSet slopingSet(int lights, float least) {
  SyntheticSet set(lights, 0);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) {
      const size_t p = size_t(y) * kWide + size_t(x);
      float albedo[3];
      for (int c = 0; c < 3; ++c) {
        float sum = 0;
        for (const Image& t : set.truth) sum += t.plane(c)[p];
        albedo[c] = .05F + .5F * sum;
      }
      const bool low = std::abs(y - kPlaceY) <= 2;
      const bool alone = low && x < 6, grey = low && x >= 8 && x < 14;
      for (size_t i = 0; i < set.truth.size(); ++i) {
        const float place = std::clamp(1.2F * float(x) / (kWide - 1) - .1F, 0.0F, 1.0F);
        float share = least + (1 - 2 * least) * (i == 0 ? place : 1 - place);
        if (i > 1) share = .5F + .5F * std::sin(.2F * float(x + 3 * y));
        if (alone) share = i == 0 ? 1 : 0;
        for (int c = 0; c < 3; ++c) set.truth[i].plane(c)[p] = share * (grey ? .5F : albedo[c]);
      }
    }
  return set;
}

/// What a person knows of a capture: all but one gel, which travels.
Capture withUnknown(Capture capture, const Rgb& gel) {
  for (Shot& shot : capture.shots) {
    shot.colorNames.assign(shot.lightColors.size(), "");
    for (size_t i = 0; i < shot.lightColors.size(); ++i)
      if (shot.lightColors[i] == gel) {
        shot.lightColors[i].reset();
        shot.colorNames[i] = kName;
      }
  }
  return capture;
}

/// The largest relative difference of two colours' channels.
float errorOf(const Rgb& found, const Rgb& truth) {
  float worst = 0;
  for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(found[c] / truth[c] - 1));
  return worst;
}

struct Swap {
  Capture truth;
  SyntheticSet set;
  Rgb gel = *truth.shots[0].lightColors[1];
  CapturePixels pixels;
  explicit Swap(float least, const std::vector<Rgb>& colors = defaultColors())
      : truth(rotatedCapture(2, colors)), set(slopingSet(2, least)) {
    truth.noise = SensorNoise{.001, 50000};
    pixels = photograph(truth, set);
  }
  [[nodiscard]] SolvedSet solved(const OpenColorChoice& choice = {}) const {
    SolveOptions options;
    options.openColor = choice;
    return solve(withUnknown(truth, gel), pixels, options);
  }
};

/// How well a set gives the photographs back, under the colours that were found: RMS over their own.
double misfitOf(const SolvedSet& set, const CapturePixels& pixels) {
  double square = 0, power = 0;
  for (size_t k = 0; k < pixels.shots.size(); ++k)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
        double y = 0;
        for (size_t i = 0; i < set.contributions.size(); ++i) {
          const auto& given = set.capture.shots[k].lightColors[i];
          y += double((given ? *given : set.report->openColor->taken)[c]) * set.contributions[i].plane(c)[p];
        }
        square += std::pow(y - pixels.shots[k].plane(c)[p], 2);
        power += std::pow(double(pixels.shots[k].plane(c)[p]), 2);
      }
  return std::sqrt(square / power);
}

TEST(UnknownColor, WithANameIsOneWhereverItStands) {
  const Capture truth = rotatedCapture(3);
  Capture capture = withUnknown(truth, *truth.shots[0].lightColors[2]);
  capture.shots[1].lightColors[0].reset();
  const std::vector<UnknownColor> unknown = unknownColorsOf(capture);
  ASSERT_EQ(unknown.size(), 2);
  EXPECT_EQ(unknown[0].name, kName);
  EXPECT_THAT(unknown[0].entries, ElementsAre(2, 4, 6));
  EXPECT_EQ(unknown[1].name, "");
  EXPECT_THAT(unknown[1].entries, ElementsAre(3));
  const LightingMatrix lighting = lightingFromCapture(capture);
  EXPECT_EQ(lighting.colors[2], lighting.colors[4]) << "it starts everywhere at the same";
  EXPECT_EQ(wordsFor(unknown[1], lighting), "the colour of light0 in shot 2");
}

TEST(UnknownColor, OfTwoSwappedShotsIsFoundWhereEachLampShinesAlone) {
  const Swap swap(0);
  const SolvedSet set = swap.solved();
  ASSERT_TRUE(set.report->openColor);
  const OpenColor& open = *set.report->openColor;
  EXPECT_FALSE(open.settled);
  EXPECT_EQ(open.position, 0);
  EXPECT_LT(errorOf(open.taken, swap.gel), .03F);
  EXPECT_LT(errorOf(open.exchanged,
                    *swap.truth.shots[0].lightColors[0] * *swap.truth.shots[0].lightColors[0] / swap.gel),
            .04F);
  EXPECT_THAT(set.report->warnings, testing::Contains(HasSubstr("leave one number of this colour open")));
  EXPECT_THAT(set.report->message, HasSubstr("?a (light1 in shot 1, light0 in shot 2) was not known"));
}

/// Most lamps have no gel. Under a warm gel the same photographs come of a gel twice as warm with the lamps
/// exchanged, and a set of warm colours, which this one is not, would be nearer to grey under that.
TEST(UnknownColor, IsNoGelWhereOneLampMayHaveNone) {
  const Rgb warm(.8F, .65F, .5F), white(1), warmer(.65F, .43F, .26F);
  for (const float least : {0.0F, .08F}) {  // even where no lamp shines alone
    const SolvedSet set = Swap(least, {warm, white}).solved();
    ASSERT_TRUE(set.report->openColor);
    const OpenColor& open = *set.report->openColor;
    EXPECT_FALSE(open.settled);
    EXPECT_LT(errorOf(open.taken, white), .03F) << least;
    EXPECT_LT(errorOf(open.exchanged, warm * warm / white), .05F);
    EXPECT_THAT(open.by, HasSubstr("without a gel"));
  }
  const SolvedSet gelled = Swap(0, {warm, warmer}).solved();
  EXPECT_THAT(gelled.report->openColor->by, HasSubstr("without a gel"))
      << "which a gel twice as warm looks like";
  EXPECT_LT(errorOf(gelled.report->openColor->exchanged, warmer), .05F) << "and the other one is named";
}

/// From white both lines come by white: a pale gel is not taken for half of itself.
TEST(UnknownColor, BesideALampWithoutAGelIsNotTakenForNone) {
  const Rgb white(1), pale(.94F, .90F, .82F);
  const SolvedSet set = Swap(0, {white, pale}).solved();
  ASSERT_TRUE(set.report->openColor);
  EXPECT_LT(errorOf(set.report->openColor->taken, pale), .03F);
  EXPECT_THAT(set.report->openColor->by, testing::Not(HasSubstr("without a gel")));
}

TEST(UnknownColor, ExchangedIsTheColourThatTheSolveNamed) {
  const Swap swap(.08F, {Rgb(.8F, .65F, .5F), Rgb(1)});
  const OpenColor named = *swap.solved().report->openColor;
  OpenColorChoice exchanged;
  exchanged.exchanged = true;
  const OpenColor taken = *swap.solved(exchanged).report->openColor;
  EXPECT_LT(errorOf(taken.taken, named.exchanged), .001F);
  EXPECT_LT(errorOf(taken.exchanged, named.taken), .001F);
}

TEST(UnknownColor, AlongItsLineExplainsTheSamePhotographs) {
  const Swap swap(.1F);
  std::vector<double> misfits;
  OpenColorChoice choice;
  for (const float position : {.5F, .7F, .9F}) {  // further than the place that is lit by one lamp
    choice.position = position;
    misfits.push_back(misfitOf(swap.solved(choice), swap.pixels));
  }
  choice.exchanged = true;
  misfits.push_back(misfitOf(swap.solved(choice), swap.pixels));
  for (const double misfit : misfits) EXPECT_NEAR(misfit, misfits.front(), .05 * misfits.front());
}

TEST(UnknownColor, IsTakenTooNearWhereNoLampShinesAlone) {
  const Swap swap(.1F);
  const OpenColor open = *swap.solved().report->openColor;
  EXPECT_GT(errorOf(open.taken, swap.gel), .1F) << "what makes the next two tests tests";
  float nearest = 1;
  for (int step = 0; step <= 200; ++step) {
    OpenColorChoice choice;
    const SwappedColorLine line{*swap.truth.shots[0].lightColors[0],
                                (*swap.truth.shots[0].lightColors[0] - open.nearest) /
                                    (*swap.truth.shots[0].lightColors[0] + open.nearest),
                                1.6F};
    nearest = std::min(nearest, errorOf(line.at(float(step) / 200), swap.gel));
  }
  EXPECT_LT(nearest, .01F) << "the line goes through the truth";
}

TEST(UnknownColor, IsSettledByAPlaceThatOneLampAloneLights) {
  const Swap swap(.1F);
  OpenColorChoice choice;
  choice.oneLamp = {"light0", kAloneX, kPlaceY};
  const OpenColor open = *swap.solved(choice).report->openColor;
  EXPECT_TRUE(open.settled);
  EXPECT_LT(errorOf(open.taken, swap.gel), .02F);
  choice.oneLamp->light = "light1";
  EXPECT_LT(errorOf(swap.solved(choice).report->openColor->exchanged, swap.gel), .02F)
      << "the other lamp's: then the lamps are exchanged";
  choice.oneLamp->light = "sun";
  EXPECT_THROW(static_cast<void>(swap.solved(choice)), InputError);
}

TEST(UnknownColor, IsSettledByAGreyPlace) {
  const Swap swap(.1F);
  OpenColorChoice choice;
  choice.grey = {kGreyX, kPlaceY};
  EXPECT_LT(errorOf(swap.solved(choice).report->openColor->taken, swap.gel), .02F);
  choice.grey = {kWide, 0};
  EXPECT_THROW(static_cast<void>(swap.solved(choice)), InputError);
}

TEST(UnknownColor, IsSettledByAPlaceOfPhotographsThatHoldAPartOfThePicture) {
  Swap swap(.1F);
  const auto carried = std::make_shared<CarriedData>();
  carried->dataWindow = PixelRect{7, 10, kWide - 7, kHigh - 10};
  swap.pixels.carried = carried;
  SolveOptions options;
  options.openColor.grey = {kGreyX, kPlaceY};  // of the whole picture
  const SolvedSet set =
      solvePhotographs(withUnknown(swap.truth, swap.gel), std::move(swap.pixels), {}, options);
  EXPECT_LT(errorOf(set.report->openColor->taken, swap.gel), .02F);
  EXPECT_THAT(set.report->openColor->by, HasSubstr(std::to_string(kGreyX) + "," + std::to_string(kPlaceY)));
}

TEST(UnknownColor, IsSettledByHowMuchLightTheGelLetsThrough) {
  const Swap swap(.1F);
  OpenColorChoice choice;
  choice.luminance = luminance(swap.gel);
  const OpenColor open = *swap.solved(choice).report->openColor;
  EXPECT_TRUE(open.settled);
  EXPECT_LT(errorOf(open.taken, swap.gel), .02F);
}

TEST(UnknownColor, RefusesALuminanceThatNoColourOfTheLineHas) {
  const Swap swap(.1F);
  OpenColorChoice choice;
  choice.luminance = .01F;
  EXPECT_THAT([&] { static_cast<void>(swap.solved(choice)); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("lets through 1 % of the light")));
}

TEST(UnknownColor, IsDeterminedByAThirdPhotograph) {
  Swap swap(.1F);
  swap.truth.shots.push_back(swap.truth.shots.front());
  swap.truth.shots.back().lightColors = {Rgb(1), Rgb(.3F)};
  swap.pixels = photograph(swap.truth, swap.set);
  const SolvedSet set = swap.solved();
  EXPECT_FALSE(set.report->openColor);
  EXPECT_LT(errorOf(set.report->refinedColors[1], swap.gel), .02F);
  EXPECT_THAT(set.report->warnings, IsEmpty());
}

TEST(UnknownColor, StaysOpenWhereTheOtherPhotographsAreBracketsOfTheTwo) {
  Swap swap(0);
  for (size_t k = 0; k < 2; ++k) {
    swap.truth.shots.push_back(swap.truth.shots[k]);
    swap.truth.shots.back().exposureStops = -2;
  }
  swap.pixels = photograph(swap.truth, swap.set);
  const SolvedSet set = swap.solved();
  ASSERT_TRUE(set.report->openColor);
  EXPECT_LT(errorOf(set.report->openColor->taken, swap.gel), .03F);
}

TEST(UnknownColor, OfThreeLightsIsDetermined) {
  Capture truth = rotatedCapture(3);
  truth.noise = SensorNoise{.001, 50000};
  const SyntheticSet set = slopingSet(3, 0);
  const Rgb gel = *truth.shots[0].lightColors[2];
  const SolvedSet solved = solve(withUnknown(truth, gel), photograph(truth, set), {});
  EXPECT_FALSE(solved.report->openColor);
  for (const size_t entry : {2, 4, 6}) EXPECT_LT(errorOf(solved.report->refinedColors[entry], gel), .02F);
  EXPECT_THAT(solved.report->warnings, IsEmpty());
}

TEST(UnknownColor, CannotBeFoundWhereNothingWasExchanged) {
  Swap swap(0);
  swap.pixels.shots[1] = swap.pixels.shots[0].clone();
  EXPECT_THROW(static_cast<void>(swap.solved()), InputError);
}

TEST(UnknownColor, TheSameInAllPhotographsOfTwoLightsIsRefused) {
  Capture capture = rotatedCapture(2);
  for (Shot& shot : capture.shots) {
    shot.lightColors.assign(2, std::nullopt);
    shot.colorNames.assign(2, kName);
  }
  const Swap swap(0);
  EXPECT_THROW(static_cast<void>(solve(capture, swap.pixels, {})), InputError);
}

}  // namespace
}  // namespace swaplight
