#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/mcc/ccm.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/chart/chart_finder.h"
#include "core/chart/chart_fit.h"
#include "core/color/srgb.h"
#include "tests/support/made_chart.h"

namespace swaplight {
namespace {

constexpr float kNoClip = std::numeric_limits<float>::infinity();

ChartFit fitOf(const test::MadeChart& made) {
  return fitChart(readChart(made.photograph(), made.full, made.corners));
}

double distance(const ChartCorners& a, const ChartCorners& b) {
  double most = 0;
  for (size_t j = 0; j < 4; ++j) most = std::max(most, std::hypot(a[j].x - b[j].x, a[j].y - b[j].y));
  return most;
}

/// The largest error of a matrix against the inverse of the made camera.
double errorOf(const CameraMatrix& matrix, const glm::dmat3& camera) {
  const glm::dmat3 truth = glm::inverse(camera);
  double most = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(matrix[size_t(i)][size_t(j)] - truth[j][i]));
  return most;
}

TEST(ChartPatches, AreThoseOfOpenCv) {
  cv::Mat any(kChartPatches, 1, CV_64FC3);
  cv::randu(any, .05, .9);
  cv::ccm::ColorCorrectionModel model(any, cv::ccm::COLORCHECKER_Macbeth);
  model.setColorSpace(cv::ccm::COLOR_SPACE_sRGB);
  model.setDistance(cv::ccm::DISTANCE_RGBL);
  model.run();
  const cv::Mat linear = model.get_dst_rgbl();
  for (size_t p = 0; p < kChartPatches; ++p)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(chartReflectances()[p][c], linear.at<cv::Vec3d>(int(p), 0)[c], 2e-3) << chartPatchName(p);
}

TEST(ChartPerspective, GoesThereAndBack) {
  const ChartCorners corners{{{210, 150}, {660, 110}, {690, 470}, {180, 420}}};
  const ChartPerspective perspective(corners);
  const PicturePlace corner = perspective.inPicture({1, 1});
  EXPECT_NEAR(corner.x, 690, 1e-9);
  EXPECT_NEAR(corner.y, 470, 1e-9);
  const ChartPlace back = perspective.inChart(perspective.inPicture({.3, .8}));
  EXPECT_NEAR(back.x, .3, 1e-12);
  EXPECT_NEAR(back.y, .8, 1e-12);
  EXPECT_THROW(ChartPerspective({{{0, 0}, {10, 0}, {20, 0}, {0, 10}}}), InputError);
  EXPECT_THROW(ChartPerspective({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}), InputError);
}

TEST(ChartFit, FindsTheCameraAndTheLightExactly) {
  test::MadeChart made;
  made.camera = test::cameraFromRec709();
  const ChartFit fit = fitOf(made);
  ASSERT_TRUE(fit.matrix);
  EXPECT_LT(errorOf(*fit.matrix, made.camera), 5e-3);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit.light[c] / made.light[c], 1, 5e-3);
  EXPECT_LT(fit.mostDeltaE, .2);
  EXPECT_GT(fit.meanBalanced, 3) << "what the matrix is there for";
  EXPECT_TRUE(fit.warnings.empty()) << fit.warnings.front();
}

TEST(ChartFit, TakesOffLightThatChangesOverTheChart) {
  test::MadeChart made;
  made.camera = test::cameraFromRec709();
  made.level = [](double x, double y) { return std::exp(.2 * (x - .5) - .3 * (y - .5)); };
  const ChartFit fit = fitOf(made);
  EXPECT_NEAR(fit.across, std::expm1(.2), .01);
  EXPECT_NEAR(fit.down, std::expm1(-.3), .01);
  EXPECT_LT(errorOf(*fit.matrix, made.camera), .01);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit.light[c] / made.light[c], 1, .01);
  ASSERT_EQ(fit.warnings.size(), 1U);
  EXPECT_NE(fit.warnings[0].find("changes over the chart"), std::string::npos);
}

TEST(ChartFit, LeavesOutSpoiledAndSaturatedPatches) {
  test::MadeChart made;
  made.camera = test::cameraFromRec709();
  made.noise = .004F;
  made.spoiled = [](size_t patch) { return patch == 4 ? Rgb(1.6F, 1.5F, 1.3F) : Rgb(1); };
  made.full = .6F;  // white's red is .73
  const ChartFit fit = fitOf(made);
  EXPECT_TRUE(fit.patches[4].outlier);
  EXPECT_TRUE(fit.patches[18].clipped);
  EXPECT_FALSE(fit.patches[19].clipped);
  EXPECT_LT(errorOf(*fit.matrix, made.camera), .02);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit.light[c] / made.light[c], 1, .01);
  EXPECT_EQ(fit.warnings.size(), 2U);  // clipped, and an outlier
  const Json json = jsonFromChartFit(fit);
  EXPECT_TRUE(json["patches"][18]["clipped"].get<bool>());
}

TEST(ChartFit, SaysWhatCannotBeTold) {
  test::MadeChart made;
  made.light = {.8F, .05F, .004F};  // a deep red
  const ChartFit red = fitOf(made);
  EXPECT_FALSE(red.matrix);
  EXPECT_NEAR(red.light.r, .8F, .01F);
  ASSERT_FALSE(red.warnings.empty());
  EXPECT_NE(red.warnings.back().find("no camera matrix"), std::string::npos);
  made.light = {8, 6, 4};
  EXPECT_THROW((void)fitOf(made), InputError) << "saturated";
  made.light = {0, 0, 0};
  EXPECT_THROW((void)fitOf(made), InputError) << "black";
}

TEST(ChartFit, SaysThatPicturesHoldNoLight) {
  test::MadeChart made;
  Image coded = made.photograph();
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < coded.pixelCount(); ++p) {
      const float v = srgbFromLinear(coded.plane(c)[p]);
      coded.plane(c)[p] = v;  // codes, called light
    }
  const ChartFit fit = fitChart(readChart(coded, kNoClip, made.corners));
  EXPECT_THAT(fit.warnings, testing::Contains(testing::HasSubstr("does not hold light")));
}

TEST(ChartFinder, FindsTheChartInPerspectiveNoiseAndColouredLight) {
  const Rgb lights[] = {{.8F, .7F, .6F}, {.9F, .4F, .12F}, {.15F, .3F, .9F}};
  for (const Rgb& light : lights) {
    test::MadeChart made;
    made.camera = test::cameraFromRec709();
    made.light = light;
    made.noise = .005F;
    const auto corners = findChart(made.photograph(), kNoClip);
    ASSERT_TRUE(corners) << light.r << " " << light.g << " " << light.b;
    EXPECT_LT(distance(*corners, made.corners), 12);
    EXPECT_LT(errorOf(*fitChart(readChart(made.photograph(), kNoClip, *corners)).matrix, made.camera), .05);
  }
}

TEST(ChartFinder, MovesCornersToWherePatchesAreEven) {
  for (const double gap : {.1, .15}) {
    test::MadeChart made;
    made.gap = gap;
    made.noise = .01F;
    ChartCorners told = made.corners;
    told[0].x -= 12, told[1].y += 12, told[2].x += 12, told[3].x += 9, told[3].y -= 9;
    EXPECT_LT(distance(orientedCorners(made.photograph(), kNoClip, told), made.corners),
              12);  // a sixth of a patch
  }
}

TEST(ChartFinder, FindsOneThatStandsOnItsHead) {
  test::MadeChart made;
  std::rotate(made.corners.begin(), made.corners.begin() + 2, made.corners.end());
  const auto corners = findChart(made.photograph(), kNoClip);
  ASSERT_TRUE(corners);
  EXPECT_LT(distance(*corners, made.corners), 12);
}

TEST(ChartFinder, FindsNoneWhereThereIsNone) {
  Image wall({400, 300, {"R", "G", "B"}, "lin_rec709"}, .2F);
  EXPECT_FALSE(findChart(wall, kNoClip));
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < wall.pixelCount(); ++p)
      wall.plane(c)[p] = ((p % 400) / 40 + p / 16000) % 2 == 0 ? .1F : .7F;  // a chess board
  EXPECT_FALSE(findChart(wall, kNoClip));
  wall.plane(0)[5] = NAN;
  EXPECT_FALSE(findChart(wall, kNoClip));
}

TEST(ChartCorners, MayBeToldFromAnyOfThemInEitherDirection) {
  test::MadeChart made;
  const Image photograph = made.photograph();
  for (const ChartCorners& told : arrangementsOf(made.corners))
    EXPECT_LT(distance(orientedCorners(photograph, kNoClip, told), made.corners), 12);
  EXPECT_THROW((void)orientedCorners(photograph, kNoClip, {{{10, 10}, {90, 10}, {90, 80}, {10, 80}}}),
               InputError);
  EXPECT_THROW((void)orientedCorners(photograph, kNoClip, {{{10, 10}, {2000, 10}, {2000, 80}, {10, 80}}}),
               InputError);
  EXPECT_THROW((void)orientedCorners(photograph, kNoClip, {{{10, 10}, {22, 10}, {22, 20}, {10, 20}}}),
               InputError);
}

}  // namespace
}  // namespace swaplight
