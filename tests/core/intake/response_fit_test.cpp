#include "core/intake/response_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using testing::HasSubstr;

using Curve = double (*)(double);  ///< light 0..1 to code 0..1

double srgb(double y) {
  return y <= .0031308 ? 12.92 * y : 1.055 * std::pow(y, 1 / 2.4) - .055;
}
/// sRGB, then more contrast: what cameras call "standard".
double contrast(double y) {
  const double v = srgb(y);
  return v + .35 * (v * v * (3 - 2 * v) - v);
}
/// A log with a straight foot.
double film(double y) {
  return std::log2(1 + 60 * y) / std::log2(61.0);
}
/// A power with a shoulder, as some JPEGs have.
double shoulder(double y) {
  const double v = std::pow(y, 1 / 1.8);
  return v * (1 + .3 * (1 - v));
}

/// A smooth set at these exposures, with noise, clipped, in 8 bits.
std::vector<Image> photographed(Curve curve, const std::vector<float>& stops, double fullWell = 20000,
                                double read = .002) {
  constexpr int kWidth = 200, kHeight = 150;
  std::mt19937 random(5);
  std::normal_distribution<double> gauss;
  std::vector<Image> codes;
  for (const float one : stops) {
    Image image(ImageSpec::rgb(kWidth, kHeight));
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const double light = std::exp2(-9 + 9.5 * x / kWidth + .8 * std::sin(.05 * y + c)) * std::exp2(one);
          const double seen = light + gauss(random) * std::sqrt(light / fullWell + read * read);
          image.span().at(c, x, y) =
              static_cast<float>(std::round(255 * curve(std::clamp(seen, 0.0, 1.0))) / 255);
        }
    codes.push_back(std::move(image));
  }
  return codes;
}

Brackets bracketOf(const std::vector<float>& stops) {
  Brackets brackets;
  brackets.length = static_cast<int>(stops.size());
  brackets.stops = stops;
  return brackets;
}

double inverse(Curve curve, double code) {
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (curve(middle) < code ? low : high) = middle;
  }
  return (low + high) / 2;
}

double largestError(const ResponseFit& fit, Curve curve) {
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    for (int z = 0; z < 256; ++z)
      largest = std::max(largest, std::abs(fit.curve.at(c, float(z) / 255) - inverse(curve, z / 255.0)));
  return largest;
}

TEST(ResponseFit, IsWithinOnePerCentOfFullScaleThroughThreeCurves) {
  const std::vector<float> stops{0, -1, -2, -3, 1, 2};
  for (const Curve curve : {contrast, film, shoulder}) {
    const ResponseFit fit = fitResponse(photographed(curve, stops), bracketOf(stops));
    EXPECT_LT(largestError(fit, curve), 0.01);
    for (int c = 0; c < 3; ++c)
      for (int z = 1; z < 256; ++z)
        ASSERT_GE(fit.curve.light[size_t(c)][size_t(z)], fit.curve.light[size_t(c)][size_t(z) - 1]);
  }
}

TEST(ResponseFit, RobertsonsMethodIsAsNearAndChecksTheOther) {
  const std::vector<float> stops{0, -1, -2, -3, 1, 2};
  for (const Curve curve : {contrast, film, shoulder}) {
    const std::vector<Image> codes = photographed(curve, stops);
    const ResponseFit fit = fitResponse(codes, bracketOf(stops), ResponseMethod::Robertson);
    EXPECT_LT(largestError(fit, curve), 0.01);
    EXPECT_LT(fit.methodDifference, 0.02);
    EXPECT_GT(fit.methodDifference, 0) << "they are two methods";
    const ResponseFit debevec = fitResponse(codes, bracketOf(stops));
    EXPECT_EQ(debevec.methodDifference, fit.methodDifference);
    std::cout << "largest error, % of full scale: Debevec and Malik " << 100 * largestError(debevec, curve)
              << ", Robertson " << 100 * largestError(fit, curve) << "\n";
  }
}

TEST(ResponseFit, StaysNearWithFewExposuresAndMoreNoise) {
  const std::vector<float> stops{0, -3, 2};
  for (const Curve curve : {contrast, film, shoulder})
    EXPECT_LT(largestError(fitResponse(photographed(curve, stops, 3000, .005), bracketOf(stops)), curve),
              0.02);
}

TEST(ResponseFit, TakesBracketsOfSeveralLightings) {
  const std::vector<float> stops{0, -2, 2, 0, -2, 2};
  std::vector<Image> codes = photographed(contrast, {0, -2, 2});
  for (Image& more : photographed(contrast, {-1, -3, 1})) codes.push_back(std::move(more));
  Brackets brackets = bracketOf(stops);
  brackets.length = 3;
  EXPECT_LT(largestError(fitResponse(codes, brackets), contrast), 0.02);
}

TEST(ResponseFit, NamesTheUsualCoding) {
  const std::vector<float> stops{0, -1, -2, -3, 1, 2};
  const ResponseFit fit = fitResponse(photographed(srgb, stops), bracketOf(stops));
  EXPECT_EQ(fit.nearest, "srgb");
  EXPECT_LT(fit.nearestDifference, 0.01);
}

TEST(ResponseFit, SaysWhatIsMissing) {
  const std::vector<float> stops{0, -2};
  EXPECT_THAT(inputError([&] {
                (void)fitResponse(photographed(srgb, stops), bracketOf({0, -0.3F}));
              }),
              HasSubstr("only 0.30 stops apart"));
  EXPECT_THAT(inputError([&] { (void)fitResponse(photographed(srgb, stops), {}); }), HasSubstr("brackets"));
  std::vector<Image> grey;
  for (int k = 0; k < 2; ++k) grey.emplace_back(ImageSpec::rgb(40, 30), k ? 0.2F : 0.4F);
  EXPECT_THAT(inputError([&] { (void)fitResponse(grey, bracketOf(stops)); }),
              HasSubstr("too little is seen"));
}

TEST(ResponseCurve, SurvivesItsFileAndContinuesPastItsEnds) {
  const std::vector<float> stops{0, -2, 2};
  const ResponseFit fit = fitResponse(photographed(film, stops), bracketOf(stops));
  const test::TemporaryFolder folder;
  writeResponse(fit.curve, folder / "film.csv");
  const ResponseCurve back = readResponse(folder / "film.csv");
  for (const float code : {0.F, .1F, .5F, .77F, 1.F})
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.at(c, code), fit.curve.at(c, code), 2e-4);
  EXPECT_GT(back.at(0, 1.1F), 1);
  EXPECT_EQ(back.at(0, -1), 0);
  EXPECT_TRUE(std::isnan(back.at(0, NAN)));
}

TEST(ResponseCurve, WrongFilesAreSaidByLine) {
  const test::TemporaryFolder folder;
  const auto complaint = [&](const char* text) {
    test::writeBytes(folder / "x.csv", text);
    return inputError([&] { (void)readResponse(folder / "x.csv"); });
  };
  EXPECT_THAT(complaint("code,light\n0,0\n0.5,0.2\n0.4,0.3\n1,1\n"),
              HasSubstr("line 4: codes and their light have to rise"));
  EXPECT_THAT(complaint("0,0\n1,much\n"), HasSubstr("line 2: expected code,red,green,blue"));
  EXPECT_THAT(complaint("0,0\n1,-1\n"), HasSubstr("not negative"));
  EXPECT_THAT(complaint("0,0\n0.5,1\n"), HasSubstr("for codes from 0 to 1"));
  EXPECT_THAT(complaint("0,0,0,0\n1,1,1,0\n"), HasSubstr("no light"));
  EXPECT_THAT(complaint(""), HasSubstr("for codes from 0 to 1"));
  EXPECT_THAT(inputError([&] { (void)readResponse(folder / "none.csv"); }), HasSubstr("is not there"));
}

}  // namespace
}  // namespace swaplight
