#include "core/solve/causes/cause_evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "core/base/json.h"
#include "core/set/solve_verdict.h"
#include "core/solve/causes/linearity.h"
#include "core/solve/causes/tone_correction.h"
#include "core/solve/even_lamps.h"
#include "core/solve/solve.h"
#include "core/solve/solve_photographs.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr SensorNoise kSensor{.0005, 200000};
constexpr int kWide = 192, kHigh = 144;

/// A matte set that can be photographed from anywhere: blobs of colour, lamps that fall off to either side
/// and down, and their shadows.
class MatteScene {
 public:
  MatteScene() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int j = 0; j < 500; ++j)
      m_blobs.push_back({kWide * unit(random), kHigh * unit(random), 1.5 + 5 * unit(random),
                         3 * (unit(random) - .4), 3 * (unit(random) - .4), 3 * (unit(random) - .4)});
  }
  [[nodiscard]] double albedo(int c, double x, double y) const {
    double log = 0;
    for (const auto& blob : m_blobs) {
      if (std::abs(x - blob[0]) > 4.3 * blob[2] || std::abs(y - blob[1]) > 4.3 * blob[2]) continue;
      const double d = (std::pow(x - blob[0], 2) + std::pow(y - blob[1], 2)) / (2 * blob[2] * blob[2]);
      if (d < 9) log += blob[size_t(3 + c)] * std::exp(-d);
    }
    return .9 / (1 + std::exp(1.2 - log));
  }
  [[nodiscard]] static double lamp(int i, double x, double y) {
    const std::array from = {x / kWide, 1 - x / kWide, y / kHigh};
    const double shadow = std::sin(.11 * x + std::array{.07, -.05, .17}.at(size_t(i)) * y);
    return (1 - .75 * from.at(size_t(i))) * (shadow > .75 ? .04 : 1);
  }

 private:
  std::vector<std::array<double, 6>> m_blobs;
};

/// What is wrong with a photograph: the value of a pixel by shot and channel, at a place.
struct Defect {
  double shift = 0;    ///< pixels to the right, of the second shot
  double drift = 0;    ///< of the first lamp's red over the half width
  double ambient = 0;  ///< behind the reflectance
  double uneven = 0;   ///< ambient light from above, and bluish: 1 is none of it at the lower edge
  std::function<double(double)> curve = [](double y) { return y; };  ///< on the light
};

Capture swappedCapture(int lights = 2) {
  Capture capture = rotatedCapture(lights);
  capture.noise = kSensor;
  return capture;
}

CapturePixels photographed(const Defect& defect = {}, int lights = 2) {
  static const MatteScene scene;
  const Capture capture = swappedCapture(lights);
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  CapturePixels pixels;
  for (int k = 0; k < lights; ++k) {
    Image image(ImageSpec::rgb(kWide, kHigh));
    for (int c = 0; c < 3; ++c)
      for (int v = 0; v < kHigh; ++v)
        for (int u = 0; u < kWide; ++u) {
          const double x = u - k * defect.shift;
          double light = defect.ambient * (1 + defect.uneven * (1 - 2.0 * v / kHigh));
          if (defect.uneven > 0) light *= 1 + .3 * (c - 1);
          for (int i = 0; i < lights; ++i) {
            const double drift = i == 0 && c == 0 ? defect.drift * (2.0 * u / kWide - 1) : 0;
            light += double((*capture.shots[size_t(k)].lightColors[size_t(i)])[c]) * (1 + drift) *
                     MatteScene::lamp(i, x, v);
          }
          const double y = defect.curve(.8 * scene.albedo(c, x, v) * light);
          image.span().at(c, u, v) =
              float(y + gauss(random) * std::sqrt(y / kSensor.fullWell + kSensor.read * kSensor.read));
        }
    pixels.shots.push_back(std::move(image));
    pixels.clipLevel.push_back(INFINITY);
    pixels.quantum.push_back(0);
  }
  return pixels;
}

MisfitCauses causesIn(const CapturePixels& pixels, const Capture& said = swappedCapture()) {
  const EstimatorContext context{lightingFromCapture(said), noiseModel(kSensor, pixels, 0)};
  const ShotSignal signal(pixels, context.lighting, context.noise, {1, 1});
  return misfitCauses(context, signal);
}

/// For a failed test's message.
std::string told(const MisfitCauses& causes) {
  return jsonFromMisfitCauses(causes).dump(1) + wordsFor(causes);
}

double sizeOf(const MisfitCauses& causes, Cause cause) {
  for (const CauseEvidence& one : causes.all)
    if (one.cause == cause) return one.size;
  return NAN;
}

double contrastCurve(double y) {
  const double v = std::pow(std::max(y, 0.0), 1 / 2.2);
  return std::pow(v + .5 * (3 * v * v - 2 * v * v * v - v), 2.2);
}

TEST(CauseEvidence, NoneWhereAllIsAsTold) {
  const MisfitCauses causes = causesIn(photographed());
  EXPECT_EQ(causes.all.size(), 5U);
  EXPECT_TRUE(causes.likely.empty()) << told(causes);
  EXPECT_EQ(wordsFor(causes), "");
}

TEST(CauseEvidence, NamesAToneCurve) {
  const MisfitCauses contrast = causesIn(photographed({.curve = contrastCurve}));
  EXPECT_TRUE(contrast.is(Cause::Tone)) << told(contrast);
  const MisfitCauses gamma = causesIn(photographed({.curve = [](double y) { return std::pow(y, .85); }}));
  ASSERT_FALSE(gamma.likely.empty()) << told(gamma);
  EXPECT_EQ(gamma.likely.front(), Cause::Tone) << "the best, though ambient light looks like it";
  EXPECT_NEAR(sizeOf(gamma, Cause::Tone), -.15, .06);
}

TEST(CauseEvidence, NamesTheCurveWhereShadowsAreDarkerThanLampsLeaveThem) {
  // As crushed as this it is no small change any more: light that is negative behind the surfaces fits as
  // well.
  const auto crushed = [](double y) {
    const double v = std::pow(std::max(y, 0.0), 1 / 2.2);
    return std::pow(v + (3 * v * v - 2 * v * v * v - v), 2.2);
  };
  const MisfitCauses causes = causesIn(photographed({.curve = crushed}));
  ASSERT_FALSE(causes.likely.empty()) << told(causes);
  EXPECT_EQ(causes.likely.front(), Cause::Tone) << told(causes);
}

TEST(CauseEvidence, NamesAMovedCamera) {
  const MisfitCauses causes = causesIn(photographed({.shift = .5}));
  EXPECT_TRUE(causes.is(Cause::Moved)) << told(causes);
  // At edges the change is not linear: what is fitted is less.
  EXPECT_GT(sizeOf(causes, Cause::Moved), .2);
  EXPECT_LT(sizeOf(causes, Cause::Moved), .6);
}

TEST(CauseEvidence, NamesLampsWhoseColourDrifts) {
  const MisfitCauses causes = causesIn(photographed({.drift = .15}));
  EXPECT_TRUE(causes.is(Cause::Field)) << told(causes);
}

TEST(CauseEvidence, NamesADriftOfTenPerCent) {
  const MisfitCauses causes = causesIn(photographed({.drift = .1}));
  EXPECT_TRUE(causes.is(Cause::Field)) << told(causes);
  EXPECT_NE(wordsFor(causes).find("--field"), std::string::npos);
}

TEST(CauseEvidence, NamesAmbientLightWithTheCurveThatLooksLikeIt) {
  const MisfitCauses causes = causesIn(photographed({.ambient = .1}));
  ASSERT_EQ(causes.likely.size(), 2U) << told(causes);
  EXPECT_EQ(causes.likely[0], Cause::Ambient);
  EXPECT_EQ(causes.likely[1], Cause::Tone);
  EXPECT_LT(sizeOf(causes, Cause::Tone), 0) << "less contrast";
  EXPECT_EQ(wordsFor(causes).find("--tone auto"), std::string::npos) << "which takes nothing off here";
  EXPECT_FALSE(findToneCorrection(swappedCapture(), photographed({.ambient = .1})).has_value());
}

// Wrong colours have more unknowns, and explain it a little better.
TEST(CauseEvidence, NamesAmbientLightThatIsNotTheSameEverywhere) {
  for (const double uneven : {.5, 1.0}) {
    const MisfitCauses causes = causesIn(photographed({.ambient = .1, .uneven = uneven}));
    ASSERT_FALSE(causes.likely.empty()) << uneven << told(causes);
    EXPECT_EQ(causes.likely.front(), Cause::Ambient) << uneven << told(causes);
    EXPECT_NE(wordsFor(causes).find("cannot be told which"), std::string::npos);
  }
}

// The evidence weighs errors to .15 only: what is seen of larger ones is no more.
TEST(CauseEvidence, NamesColoursThatAreWrongByMoreThanIsWeighed) {
  Capture said = swappedCapture();
  for (auto& color : said.shots[0].lightColors) color->r *= 2.5F;
  for (auto& color : said.shots[1].lightColors) color->b *= .4F;
  (*said.shots[0].lightColors[0]).g *= 2;
  const MisfitCauses causes = causesIn(photographed(), said);
  EXPECT_GT(sizeOf(causes, Cause::Colors), .3) << told(causes);
  ASSERT_FALSE(causes.likely.empty()) << told(causes);
  EXPECT_EQ(causes.likely.front(), Cause::Colors) << told(causes);
}

TEST(CauseEvidence, NamesNoNegativeAmbientLight) {
  // A black level taken off twice; and what bounced light looks like.
  const MisfitCauses causes = causesIn(photographed({.ambient = -.03}));
  for (const Cause cause : causes.likely) EXPECT_NE(cause, Cause::Ambient) << told(causes);
}

TEST(CauseEvidence, NamesWrongColours) {
  Capture said = swappedCapture();
  (*said.shots[0].lightColors[0]).r *= 1.15F;
  (*said.shots[1].lightColors[0]).b *= .85F;
  const MisfitCauses causes = causesIn(photographed(), said);
  EXPECT_TRUE(causes.is(Cause::Colors)) << told(causes);
}

TEST(CauseEvidence, IsKeptWithTheReportAndLowersTheVerdict) {
  SolveReport report;
  report.pixels = 1000;
  EXPECT_EQ(verdictOf(report).word, SolveVerdict::Word::Good);
  MisfitCauses causes;
  causes.all = {{Cause::Tone, .6, .4, 7, 0, .08}, {Cause::Colors, .5, .3, 6, 1.2, .04}};
  causes.likely = {Cause::Tone};
  report.causes = causes;
  const SolveReport read = solveReportFromJson(jsonFromSolveReport(report), "report");
  EXPECT_TRUE(read.causes.is(Cause::Tone));
  EXPECT_EQ(read.causes.all.size(), 2U);
  EXPECT_EQ(read.causes.all.back().behind, 1.2);
  const SolveVerdict verdict = verdictOf(read);
  EXPECT_EQ(verdict.word, SolveVerdict::Word::Fair);
  ASSERT_FALSE(verdict.reasons.empty());
  EXPECT_NE(verdict.reasons.front().find("1.08"), std::string::npos) << verdict.reasons.front();
  EXPECT_NE(verdict.reasons.front().find("--tone auto"), std::string::npos);
  causes.likely.push_back(Cause::Colors);
  EXPECT_NE(wordsFor(causes).find("cannot be told which"), std::string::npos);
}

std::optional<double> seenFrom(const MisfitCauses& causes, Cause cause) {
  const auto found = std::ranges::find(causes.sight, cause, &CauseSight::cause);
  return found == causes.sight.end() ? std::nullopt : found->from;
}

// What is not said is no proof that nothing is wrong: how much could be is measured on the photographs
// themselves.
TEST(CauseEvidence, KnowsWhatWouldGoUnseen) {
  const auto solved = [](const Defect& defect) {
    SolveOptions options;
    options.align = options.correctTone = Remedy::Off;
    return solvePhotographs(swappedCapture(), photographed(defect), {}, options).report->causes;
  };
  const MisfitCauses clean = solved({});
  ASSERT_TRUE(clean.likely.empty()) << told(clean);
  const std::optional<double> drift = seenFrom(clean, Cause::Field);
  ASSERT_TRUE(drift && seenFrom(clean, Cause::Ambient)) << told(clean);
  EXPECT_EQ(clean.sight.back().cause, Cause::Colors) << "of two lights they seldom show";
  EXPECT_FALSE(clean.sight.back().from);
  // Really photographed like that, more is said, and less is not. Of all lamps and channels one drifts.
  const double ofOne = *drift * std::sqrt(6. * 3);
  for (const auto& [times, isSaid] : {std::pair{.5, false}, std::pair{1.5, true}}) {
    const MisfitCauses causes = solved({.drift = times * ofOne});
    EXPECT_EQ(!causes.likely.empty(), isSaid) << times << ' ' << *drift << ' ' << told(causes);
    EXPECT_EQ(causes.sight.empty(), isSaid) << "where something is said it is not looked for";
    // What is in them unsaid does not make them seem to show more.
    if (!isSaid) {
      EXPECT_GT(seenFrom(causes, Cause::Field).value_or(1), .7 * *drift);
    }
  }

  // Not where the photographs were solved as something else than what they were compared as.
  SolveOptions refined;
  refined.refineColors = true;
  EXPECT_TRUE(solvePhotographs(swappedCapture(), photographed(), {}, refined).report->causes.sight.empty());
  Capture dark = swappedCapture();
  dark.ambient = "dark.exr";
  const MisfitCauses without = solvePhotographs(dark, photographed(), {}, {}).report->causes;
  EXPECT_FALSE(without.sight.empty());
  EXPECT_EQ(std::ranges::count(without.sight, Cause::Ambient, &CauseSight::cause), 0) << "was taken off";

  // In whatever units.
  CapturePixels dim = photographed();
  for (Image& shot : dim.shots)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < shot.pixelCount(); ++p) shot.plane(c)[p] *= 0x1p-20F;
  Capture less = swappedCapture();
  less.noise = SensorNoise{kSensor.read * 0x1p-20F, kSensor.fullWell * 0x1p20F};
  EXPECT_EQ(unseenWords(solvePhotographs(less, std::move(dim), {}, {}).report->causes), unseenWords(clean));

  SolveReport report;
  report.causes = clean;
  const MisfitCauses read = solveReportFromJson(jsonFromSolveReport(report), "report").causes;
  EXPECT_EQ(seenFrom(read, Cause::Field), drift);
  EXPECT_EQ(unseenWords(read), unseenWords(clean));
  EXPECT_NE(unseenWords(clean).find("ambient light below"), std::string::npos) << unseenWords(clean);
  EXPECT_EQ(unseenWords({}), "");
}

// Each shadow lets the other lights take up some of what is planted, as of what is really there.
TEST(CauseEvidence, KnowsWhatWouldGoUnseenOfThreeLights) {
  const auto solved = [](double ambient) {
    SolveOptions options;
    options.align = options.correctTone = Remedy::Off;
    return solvePhotographs(swappedCapture(3), photographed({.ambient = ambient}, 3), {}, options)
        .report->causes;
  };
  const MisfitCauses clean = solved(0);
  ASSERT_TRUE(clean.likely.empty()) << told(clean);
  const std::optional<double> from = seenFrom(clean, Cause::Ambient);
  ASSERT_TRUE(from) << told(clean);
  EXPECT_TRUE(seenFrom(clean, Cause::Tone) && seenFrom(clean, Cause::Field)) << told(clean);
  EXPECT_EQ(std::ranges::count(clean.sight, Cause::Colors, &CauseSight::cause), 0)
      << "of three lights wrong ones show";
  const MisfitCauses more = solved(1.3 * *from);
  EXPECT_TRUE(more.is(Cause::Ambient)) << told(more);
  const MisfitCauses less = solved(.3 * *from);
  EXPECT_TRUE(less.likely.empty()) << told(less);
  EXPECT_GE(seenFrom(less, Cause::Ambient).value_or(1), *from) << "what is in them unsaid shows no more";
}

// Light that the colours as told make negative, all over the picture, is no bounced light: something is
// wrong, though none of the causes is surely it.
TEST(CauseEvidence, SaysThatSomethingIsWrongWhereNoneCanBeNamed) {
  MisfitCauses causes;
  causes.all = {{Cause::Ambient, .9, .4, 7, 0, -.1}, {Cause::Tone, .7, .3, 6, 3, .2}};
  EXPECT_TRUE(isUnnamed(causes, .15));
  EXPECT_FALSE(isUnnamed(causes, .01)) << "bounced light";
  causes.likely = {Cause::Tone};
  EXPECT_FALSE(isUnnamed(causes, .15)) << "it has a name";
  causes.likely.clear();
  causes.all.front().explained = causes.all.back().explained = .3;
  EXPECT_FALSE(isUnnamed(causes, .15)) << "colours that are told roughly";

  SolveReport report;
  report.pixels = 1000;
  report.causes.unnamed = true;
  const SolveReport read = solveReportFromJson(jsonFromSolveReport(report), "report");
  EXPECT_TRUE(read.causes.unnamed);
  EXPECT_EQ(verdictOf(read).word, SolveVerdict::Word::Fair);
  EXPECT_NE(verdictOf(read).reasons.front().find("cannot be told why"), std::string::npos);
}

TEST(CauseEvidence, ACurveIsSureWhereNothingElseIsNearlyAsLikely) {
  MisfitCauses causes;
  causes.all = {{Cause::Tone, .5, .4, 8, 0, .1}, {Cause::Ambient, .4, .3, 7, 3, .1}};
  EXPECT_FALSE(isSurelyTone(causes)) << "none is likely";
  causes.likely = {Cause::Tone};
  EXPECT_TRUE(isSurelyTone(causes));
  causes.all.back().behind = 1;
  EXPECT_FALSE(isSurelyTone(causes)) << "ambient light explains it as well";
  causes.all.back().size = -.1;
  EXPECT_TRUE(isSurelyTone(causes)) << "there is no negative light";
  causes.all.push_back({Cause::Colors, .45, .45, 8, 2.3, .1});
  EXPECT_FALSE(isSurelyTone(causes)) << "colours explain more";
  causes.all.pop_back();
  causes.all.back().size = .1;
  causes.all.back().behind = 3, causes.all.front().certainty = 4.9;
  EXPECT_FALSE(isSurelyTone(causes));
  causes.all.front().certainty = 8, causes.likely = {Cause::Tone, Cause::Ambient};
  EXPECT_FALSE(isSurelyTone(causes));
}

/// Of the contributions, up to a factor: under an unknown curve the exposure is open.
double relativeError(const SolvedSet& set, const SolvedSet& truth) {
  double own = 0, both = 0, power = 0;
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < truth.beta.pixelCount(); ++p) {
        const double t = double(truth.contributions[i].plane(c)[p]);
        const double s = double(set.contributions[i].plane(c)[p]);
        own += s * s;
        both += s * t;
        power += t * t;
      }
  return std::sqrt(std::max(1 - both * both / (own * power), 0.0));
}

TEST(ToneCorrection, TakesOffACurve) {
  const SolvedSet truth = solve(swappedCapture(), photographed(), {});
  CapturePixels pixels = photographed({.curve = contrastCurve});
  const double before = relativeError(solve(swappedCapture(), pixels, {}), truth);
  const auto tone = findToneCorrection(swappedCapture(), pixels);
  ASSERT_TRUE(tone.has_value());
  EXPECT_TRUE(tone->steady);
  correctTone(tone->correction, pixels);
  const SolvedSet corrected = solve(swappedCapture(), pixels, {});
  EXPECT_LT(relativeError(corrected, truth), .3 * before) << tone->correction.exponent();
  EXPECT_TRUE(corrected.report->causes.likely.empty()) << told(corrected.report->causes);
}

TEST(ToneCorrection, ThatIsNotSteadyDoesNotTellWhetherPhotographsHoldLight) {
  const CapturePixels pixels = photographed({.curve = contrastCurve});
  CauseTuning tuning;
  using Answer = LinearityEvidence::Answer;
  EXPECT_EQ(linearityOf(swappedCapture(), pixels, {}, tuning).answer, Answer::Curved);
  tuning.steadyExponent = 0;  // no two fits agree to nothing
  const LinearityEvidence evidence = linearityOf(swappedCapture(), pixels, {}, tuning);
  EXPECT_EQ(evidence.answer, Answer::Unknown);
  EXPECT_NE(evidence.words.find("bounced or ambient light"), std::string::npos) << evidence.words;
  EXPECT_FALSE(evidence.curve.empty());
}

TEST(ToneCorrection, ThatIsNotSteadyIsReportedWithAWarning) {
  SolveReport steady, unsteady;
  reportTone({}, steady);
  reportTone({{}, false}, unsteady);
  EXPECT_TRUE(steady.warnings.empty());
  ASSERT_EQ(unsteady.warnings.size(), 1U);
  EXPECT_NE(unsteady.warnings[0].find("not sure"), std::string::npos);
  EXPECT_TRUE(unsteady.tone.has_value());
}

TEST(ToneCorrection, IsAnOptionOfEverySolveOfPhotographs) {
  SolveOptions options;
  const auto solved = [&](const Defect& defect) {
    return solvePhotographs(swappedCapture(), photographed(defect), {}, options);
  };
  const Defect curved{.curve = contrastCurve};
  options.correctTone = Remedy::Off;
  EXPECT_FALSE(solved(curved).report->tone);
  options.correctTone = Remedy::Sure;
  const SolvedSet unasked = solved(curved);
  EXPECT_TRUE(unasked.report->tone);
  EXPECT_NE(unasked.report->warnings.back().find("--tone declared"), std::string::npos);
  EXPECT_TRUE(solved({}).report->warnings.empty());
  options.correctTone = Remedy::On;
  const SolvedSet corrected = solved(curved);
  EXPECT_TRUE(corrected.report->tone);
  EXPECT_TRUE(corrected.report->causes.likely.empty()) << told(corrected.report->causes);
  const SolvedSet plain = solved({});
  EXPECT_FALSE(plain.report->tone);
  EXPECT_NE(plain.report->message.find("none was taken off"), std::string::npos);
}

SolveOptions evening() {
  SolveOptions options;
  options.field = true;
  return options;
}

TEST(LampDrift, IsFoundInThePhotographsAndEvened) {
  const SolvedSet truth = solve(swappedCapture(), photographed(), {});
  const CapturePixels pixels = photographed({.drift = .15});
  const double before = relativeError(solve(swappedCapture(), pixels, {}), truth);
  const SolvedSet evened = solveUneven(swappedCapture(), pixels, {}, evening());
  EXPECT_LT(relativeError(evened, truth), .8 * before) << "half of a lamp's drift is both lamps', too";
  const std::vector<LampField> found =
      solveReportFromJson(jsonFromSolveReport(*evened.report), "report").lampFields;
  ASSERT_EQ(found.size(), 2U);
  // The lamps over each other is what matte surfaces show: red over green from the left to the right edge.
  const auto rise = [](const LampField& field) {
    const auto redOverGreen = [&](size_t corner) {
      return std::log(field.corners[corner][0] / field.corners[corner][1]);
    };
    return .5 * (redOverGreen(1) + redOverGreen(3) - redOverGreen(0) - redOverGreen(2));
  };
  EXPECT_NEAR(rise(found[0]) - rise(found[1]), std::log(1.15 / .85), .06);
  EXPECT_LT(found[1].size, found[0].size) << "where beta goes from lamp to lamp, which of them it is";
  EXPECT_TRUE(evened.report->causes.likely.empty()) << told(evened.report->causes);
}

TEST(LampDrift, OfEvenLampsIsNone) {
  const CapturePixels pixels = photographed();
  const SolvedSet asked = solveUneven(swappedCapture(), pixels, {}, evening());
  const SolvedSet plain = solve(swappedCapture(), pixels, {});
  for (size_t p = 0; p < pixels.shots[0].pixelCount(); ++p)
    ASSERT_EQ(asked.contributions[0].plane(0)[p], plain.contributions[0].plane(0)[p]);
  EXPECT_TRUE(asked.report->lampFields.empty());
  ASSERT_FALSE(asked.report->warnings.empty());
  EXPECT_NE(asked.report->warnings.back().find("nothing was evened"), std::string::npos);
  Capture unknown = swappedCapture();
  unknown.shots[0].lightColors[0].reset();
  const SolvedSet untold = solveUneven(unknown, pixels, {}, evening());
  EXPECT_TRUE(untold.report->lampFields.empty());
  EXPECT_NE(untold.report->warnings.back().find("a colour is unknown"), std::string::npos);
}

TEST(ToneCorrection, LeavesPhotographsThatAreAsTold) {
  EXPECT_FALSE(findToneCorrection(swappedCapture(), photographed()).has_value());
  Capture unknown = swappedCapture();
  unknown.shots[0].lightColors[0].reset();
  EXPECT_ANY_THROW((void)findToneCorrection(unknown, photographed()));
}

}  // namespace
}  // namespace swaplight
