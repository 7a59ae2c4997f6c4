// What a person says of places: "this is shadow", "this is lit".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/shadow/detect/detect_shadows.h"
#include "core/shadow/detect/shadow_cut.h"
#include "core/shadow/detect/shadow_preview.h"
#include "core/shadow/marks/mark_word.h"
#include "core/shadow/numeric/surface_distance.h"
#include "core/shadow/result/label_mask.h"
#include "core/shadow/result/untold_pixels.h"

namespace swaplight {
namespace {

using Kind = ShadowMark::Kind;
using testing::HasSubstr;

TEST(SurfaceDistance, GoesAroundWhatCostsMore) {
  cv::Mat cost(41, 41, CV_32F, cv::Scalar(1));
  cost(cv::Rect(20, 0, 1, 31)).setTo(100);  // a wall with an end
  const cv::Mat distance = surfaceDistance(cost, {10, 5}, 1000);
  EXPECT_FLOAT_EQ(distance.at<float>(5, 10), 0);
  EXPECT_FLOAT_EQ(distance.at<float>(5, 0), 10);
  EXPECT_NEAR(distance.at<float>(15, 0), 10 * std::sqrt(2.F), 1e-3F);
  EXPECT_GT(distance.at<float>(5, 30), 2 * std::hypot(10.F, 26.F) - .5F) << "not through the wall";
  EXPECT_LT(distance.at<float>(5, 30), 70) << "nor farther than around its end";
  EXPECT_FLOAT_EQ(surfaceDistance(cost, {10, 5}, 7).at<float>(40, 40), 7);
}

// An even surface whose left half is darker by so much.
cv::Mat halfDark(float dark) {
  cv::Mat shading(240, 480, CV_32F, cv::Scalar(0));
  shading.colRange(0, 240).setTo(-dark);
  return shading;
}

TEST(MarkWord, SpeaksForAllOfAnEvenSurfaceAndLessTheFartherItIs) {
  const cv::Mat even = halfDark(0);
  const cv::Mat none = cv::Mat::zeros(even.size(), CV_32F);
  const cv::Mat word = wordOfMarks({{Kind::Lit, 100, 100}}, {even, none}, even.size());
  EXPECT_FLOAT_EQ(word.at<float>(100, 100), 1);
  EXPECT_GT(word.at<float>(100, 110), .9F);
  EXPECT_GT(word.at<float>(100, 200), .5F);
  EXPECT_LT(word.at<float>(100, 400), word.at<float>(100, 200));
  EXPECT_GE(word.at<float>(100, 400), 0);
  const cv::Mat shadow = wordOfMarks({{Kind::Shadow, 100, 100}}, {even, none}, even.size());
  EXPECT_EQ(cv::norm(word + shadow, cv::NORM_INF), 0);
  EXPECT_TRUE(wordOfMarks({}, {even, none}, even.size()).empty());
}

TEST(MarkWord, SaysNothingBeyondABorder) {
  const cv::Mat even = halfDark(0);
  cv::Mat borders = cv::Mat::zeros(even.size(), CV_32F);
  borders.colRange(238, 242).setTo(3);  // a clear step of the light
  const cv::Mat word = wordOfMarks({{Kind::Lit, 200, 100}}, {even, borders}, even.size());
  EXPECT_GT(word.at<float>(100, 230), .7F);
  EXPECT_LT(word.at<float>(100, 250), .05F);
  borders = cv::Mat(even.size(), CV_32F, cv::Scalar(.4));  // noise
  EXPECT_GT(wordOfMarks({{Kind::Lit, 200, 100}}, {even, borders}, even.size()).at<float>(100, 250), .6F);
}

TEST(MarkWord, LitSpeaksForWhatIsAsBrightAndShadowForWhatIsAsDark) {
  const cv::Mat shading = halfDark(1.5F);
  const cv::Mat none = cv::Mat::zeros(shading.size(), CV_32F);
  const auto word = [&](Kind is, int x) {
    return wordOfMarks({{is, x, 120}}, {shading, none}, shading.size());
  };
  EXPECT_GT(word(Kind::Lit, 230).at<float>(120, 260), .7F) << "a dim place is lit: so is a bright one";
  EXPECT_LT(word(Kind::Lit, 260).at<float>(120, 220), .1F) << "a bright place is lit: of a dim one, nothing";
  EXPECT_LT(word(Kind::Shadow, 260).at<float>(120, 220), -.7F);
  EXPECT_GT(word(Kind::Shadow, 230).at<float>(120, 260), -.1F);
}

// The left half is told to be lit, by as many log-odds.
float wordOver(float leftLit, ShadowMark mark, int x) {
  const cv::Mat even = halfDark(0);
  const cv::Mat none = cv::Mat::zeros(even.size(), CV_32F);
  cv::Mat evidence = none.clone();
  evidence.colRange(0, 240).setTo(leftLit);
  return wordOfMarks({mark}, {even, none, evidence}, even.size()).at<float>(100, x);
}

TEST(MarkWord, DoesNotGoFarThroughWhatSpeaksAgainstIt) {
  const ShadowMark inside{Kind::Shadow, 200, 100};
  EXPECT_LT(wordOver(4, inside, 201), -.9F) << "the place itself is obeyed";
  EXPECT_GT(wordOver(4, inside, 120), -.3F) << "but not far around";
  EXPECT_LT(wordOver(0, inside, 120), -.5F) << "as where nothing is known";
  EXPECT_FLOAT_EQ(wordOver(-4, inside, 120), wordOver(0, inside, 120)) << "or where the search agrees";
  EXPECT_NEAR(wordOver(4, {Kind::Lit, 200, 100}, 120), wordOver(0, {Kind::Lit, 200, 100}, 120), 1e-6);
}

TEST(MarkWord, SaysLessOfEvidenceThatItDoesNotRefute) {
  const ShadowMark outside{Kind::Shadow, 250, 100};
  // What is told lit more surely than the marked place was: three powers of e, the most that evidence counts.
  const float most = std::exp(-3 * ShadowMarkTuning{}.stronger);
  EXPECT_NEAR(wordOver(4, outside, 238), -most, .03F);
  EXPECT_LT(wordOver(0, outside, 238), -.85F);
}

TEST(MarkWord, BetweenTwoThatContradictTheNearerHasIt) {
  const cv::Mat even = halfDark(0);
  const cv::Mat none = cv::Mat::zeros(even.size(), CV_32F);
  const cv::Mat word =
      wordOfMarks({{Kind::Shadow, 200, 100}, {Kind::Lit, 280, 100}}, {even, none}, even.size());
  EXPECT_FLOAT_EQ(word.at<float>(100, 200), -1);
  EXPECT_FLOAT_EQ(word.at<float>(100, 280), 1);
  EXPECT_LT(word.at<float>(100, 210), -.5F);
  EXPECT_GT(word.at<float>(100, 270), .5F);
  EXPECT_NEAR(word.at<float>(100, 240), 0, .05F);
  // In one pixel the later one.
  const cv::Mat later =
      wordOfMarks({{Kind::Shadow, 200, 100}, {Kind::Lit, 200, 100}}, {even, none}, even.size());
  EXPECT_FLOAT_EQ(later.at<float>(100, 200), 1);
}

TEST(MarkWord, NamesPixelsOfThePictureNotOfItsSmallCopy) {
  EXPECT_EQ(markedPixel({Kind::Lit, 1919, 1079}, {1920, 1080}, {480, 270}), cv::Point(479, 269));
  EXPECT_EQ(markedPixel({Kind::Lit, 0, 3}, {1920, 1080}, {480, 270}), cv::Point(0, 0));
  EXPECT_EQ(markedPixel({Kind::Lit, 7, 9}, {20, 20}, {20, 20}), cv::Point(7, 9));
}

// Odds that do not know, and a level that calls the left half shadow.
ShadowDivision dividedWith(const ShadowMarks& marks) {
  const cv::Size size(240, 160);
  cv::Mat level(size, CV_32F, cv::Scalar(2));
  level.colRange(0, 120).setTo(-2);
  const LightOdds odds{cv::Mat(size, CV_32F, cv::Scalar(-.6)), cv::Mat(size, CV_32F, cv::Scalar(.5)),
                       cv::Mat(size, CV_32F, cv::Scalar(.5))};
  const cv::Mat nothing = cv::Mat::zeros(size, CV_32F);
  const cv::Mat word = wordOfMarks(marks, {level, nothing}, size);
  return divideShadow(level, 0, {nothing, nothing, nothing}, odds, word);
}

TEST(DivideShadow, AMarkTellsWhatCouldNotBeTold) {
  const cv::Rect dark(4, 4, 112, 152);
  ASSERT_GT(cv::countNonZero(dividedWith({}).untold(dark)), .95 * dark.area());
  for (const Kind is : {Kind::Shadow, Kind::Lit}) {
    const ShadowDivision division = dividedWith({{is, 60, 80}});
    EXPECT_EQ(cv::countNonZero(division.untold(dark)), 0) << "one click for the whole surface";
    const double shadow = cv::countNonZero(division.shadow(dark)) / static_cast<double>(dark.area());
    EXPECT_NEAR(shadow, is == Kind::Shadow ? 1 : 0, .01)
        << "but for corners, which are borders' to the opening";
    EXPECT_EQ(cv::countNonZero(division.shadow.colRange(124, 240)), 0) << "the bright half stays lit";
  }
}

// How many pixels stay untold with a word of .3 for light, and odds of umbra.
int untoldWith(float oddsOfUmbra) {
  const cv::Size size(60, 40);
  const auto even = [&](float value) { return cv::Mat(size, CV_32F, cv::Scalar(value)); };
  const LightOdds odds{even(oddsOfUmbra), even(-oddsOfUmbra), even(.5F)};
  return cv::countNonZero(divideShadow(even(0), 0, {even(0), even(0), even(0)}, odds, even(.3F)).untold);
}

TEST(DivideShadow, AWordThatSaysTheSameLeavesLessDoubtOneThatDoesNotLeavesMore) {
  EXPECT_EQ(untoldWith(.5F), 0) << "the word outweighs what hardly speaks for umbra";
  EXPECT_GT(untoldWith(4.5F), 0) << "umbra is likely, but a person says that it is lit near by";
}

constexpr int kWidth = 320, kHeight = 160;
constexpr int kLeft = 90, kRight = 230;  // the middles of two discs' shadows

// A printed floor under two lights; two discs hide the first, with soft rims, so many times as large. A
// corner is black.
SolvedSet twoShadows(int times = 1) {
  SolvedSet set;
  set.capture.lights = {{"key", Role::Key, Json::object()}, {"fill", Role::Fill, Json::object()}};
  for (int i = 0; i < 2; ++i) set.contributions.emplace_back(ImageSpec::rgb(kWidth * times, kHeight * times));
  for (int y = 0; y < kHeight * times; ++y)
    for (int x = 0; x < kWidth * times; ++x) {
      const float u = (static_cast<float>(x) + .5F) / static_cast<float>(times);
      const float v = (static_cast<float>(y) + .5F) / static_cast<float>(times);
      const float distance = std::min(std::hypot(u - kLeft, v - 80), std::hypot(u - kRight, v - 80));
      const float visible = std::clamp((distance - 30) / 8, 0.F, 1.F);
      const float albedo = u < 30 && v < 30 ? 0 : static_cast<int>(u / 16) % 2 == 0 ? .5F : .3F;
      for (int c = 0; c < 3; ++c) {
        set.contributions[0].span().at(c, x, y) = albedo * (.7F * visible + .02F);
        set.contributions[1].span().at(c, x, y) = albedo * (.3F + .1F * v / kHeight);
      }
    }
  updateBeta(set);
  return set;
}

LightShadows foundWith(const SolvedSet& set, const ShadowMarks& marks) {
  ShadowOptions options;
  if (!marks.empty()) options.marks["key"] = marks;
  return std::move(detectShadows(set, options)[0]);
}

ShadowLabel labelAt(const LightShadows& shadows, int x, int y) {
  return shadows.labels[static_cast<size_t>(y) * static_cast<size_t>(shadows.visibility.width()) +
                        static_cast<size_t>(x)];
}

double meanVisibility(const LightShadows& shadows, int x, int y, int half) {
  double sum = 0;
  for (int row = y - half; row <= y + half; ++row)
    for (int column = x - half; column <= x + half; ++column)
      sum += shadows.visibility.view().at(0, column, row);
  return sum / ((2 * half + 1) * (2 * half + 1));
}

TEST(ShadowMarks, AShadowThatIsCalledLitIsNoneAnyMoreAndTheOtherStays) {
  const SolvedSet set = twoShadows();
  ASSERT_LT(meanVisibility(foundWith(set, {}), kLeft, 80, 16), .1);
  const LightShadows found = foundWith(set, {{Kind::Lit, kLeft, 80}});
  EXPECT_EQ(labelAt(found, kLeft, 80), ShadowLabel::Lit);
  EXPECT_GT(meanVisibility(found, kLeft, 80, 16), .95);
  EXPECT_LT(meanVisibility(found, kRight, 80, 16), .1);
}

TEST(ShadowMarks, ALitPlaceThatIsCalledShadowIsShadowAndIsFilledAsOne) {
  const SolvedSet set = twoShadows();
  const LightShadows before = foundWith(set, {});
  const LightShadows found = foundWith(set, {{Kind::Shadow, 160, 30}});
  EXPECT_EQ(labelAt(before, 160, 30), ShadowLabel::Lit);
  EXPECT_EQ(labelAt(found, 160, 30), ShadowLabel::Umbra);
  EXPECT_LT(meanVisibility(found, 160, 30, 3), .2) << "its surroundings, not the pixel alone";
  for (size_t p = 0; p < found.visibility.pixelCount(); ++p) {
    ASSERT_TRUE(found.visibility.plane(0)[p] >= 0 && found.visibility.plane(0)[p] <= 1);
    ASSERT_TRUE(std::isfinite(found.direct.plane(1)[p]) && found.direct.plane(1)[p] >= 0);
  }
}

TEST(ShadowMarks, WhatTheSearchFindsAnywayStaysAsItIs) {
  const SolvedSet set = twoShadows();
  const LightShadows before = foundWith(set, {});
  const LightShadows found = foundWith(set, {{Kind::Shadow, kLeft, 80}, {Kind::Lit, 160, 80}});
  double difference = 0;
  for (size_t p = 0; p < found.visibility.pixelCount(); ++p)
    difference += std::abs(found.visibility.plane(0)[p] - before.visibility.plane(0)[p]);
  EXPECT_LT(difference / static_cast<double>(found.visibility.pixelCount()), .01);
}

TEST(ShadowMarks, TellWhereItIsTooDarkToTell) {
  const SolvedSet set = twoShadows();
  ASSERT_EQ(labelAt(foundWith(set, {}), 12, 12), ShadowLabel::Unknown);
  EXPECT_EQ(labelAt(foundWith(set, {{Kind::Shadow, 12, 12}}), 12, 12), ShadowLabel::Umbra);
  EXPECT_EQ(labelAt(foundWith(set, {{Kind::Lit, 12, 12}}), 12, 12), ShadowLabel::Lit);
}

TEST(ShadowMarks, HoldBesideAThresholdToo) {
  const SolvedSet set = twoShadows();
  ShadowOptions options;
  options.thresholds["key"] = .3F;
  options.marks["key"] = {{Kind::Lit, kLeft, 80}};
  const LightShadows found = std::move(detectShadows(set, options)[0]);
  EXPECT_GT(meanVisibility(found, kLeft, 80, 16), .95);
  EXPECT_LT(meanVisibility(found, kRight, 80, 16), .1);
}

TEST(ShadowMarks, ThePreviewShowsWhatIsFound) {
  const SolvedSet set = twoShadows(6);  // larger than the preview's picture
  const ShadowPreview preview(set);
  const ShadowMarks marks{{Kind::Lit, 6 * kLeft, 480}, {Kind::Shadow, 960, 180}};
  const PreviewedShadows seen = preview.shadows(0, {}, marks);
  ASSERT_GT(seen.scale, 1);
  const auto label = [&](int x, int y) {
    return seen
        .labels[static_cast<size_t>(static_cast<float>(y) / seen.scale) * static_cast<size_t>(seen.width) +
                static_cast<size_t>(static_cast<float>(x) / seen.scale)];
  };
  EXPECT_EQ(label(6 * kLeft, 480), ShadowLabel::Lit);
  EXPECT_EQ(label(6 * kRight, 480), ShadowLabel::Umbra);
  EXPECT_EQ(label(960, 180), ShadowLabel::Umbra);
}

TEST(ShadowMarks, WhatTheSetDoesNotHaveIsSaid) {
  const SolvedSet set = twoShadows();
  const auto message = [&](const ShadowOptions& options) {
    try {
      static_cast<void>(detectShadows(set, options));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  ShadowOptions options;
  options.marks["key"] = {{Kind::Lit, kWidth, 5}};
  EXPECT_THAT(message(options),
              testing::AllOf(HasSubstr("key"), HasSubstr("320, 5"), HasSubstr("320 x 160")));
  options.marks = {{"rim", {{Kind::Lit, 5, 5}}}};
  EXPECT_THAT(message(options), HasSubstr("rim"));
}

TEST(UntoldPixels, KnowWhereNothingIsTold) {
  std::vector<ShadowLabel> labels(20, ShadowLabel::Lit);  // 5 x 4
  for (const size_t p : {6U, 7U, 11U, 12U}) labels[p] = ShadowLabel::Unknown;
  const UntoldPixels untold(labels, 5, 2);
  EXPECT_NEAR(untold.share(), 4 / 20., 1e-6);
  EXPECT_TRUE(untold.at(2.5F, 3.5F));
  EXPECT_FALSE(untold.at(6.5F, 3.5F));
  EXPECT_FALSE(untold.at(-1, 3));
  EXPECT_FALSE(untold.at(2.5F, 8));
  EXPECT_FALSE(UntoldPixels().at(0, 0));
}

// Right of umbra in the first two columns, left of light in the last two.
TEST(UntoldPixels, InALineAreTheBorderOfAnUmbra) {
  std::vector<ShadowLabel> labels(25, ShadowLabel::Lit);
  for (size_t y = 0; y < 5; ++y) {
    labels[5 * y] = labels[5 * y + 1] = ShadowLabel::Umbra;
    labels[5 * y + 2] = ShadowLabel::Unknown;
  }
  const UntoldPixels untold(labels, 5, 1);
  EXPECT_NEAR(untold.share(), .2, 1e-6);
  EXPECT_FALSE(untold.at(2.5F, 2.5F));
  EXPECT_EQ(cv::countNonZero(labelMask(labels, 5, ShadowLabel::Umbra)), 10);
  EXPECT_EQ(cv::countNonZero(labelMask(labels, 5, ShadowLabel::Penumbra)), 15);
}

}  // namespace
}  // namespace swaplight
