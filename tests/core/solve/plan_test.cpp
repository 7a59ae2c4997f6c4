#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/color/srgb.h"
#include "core/plan/plan_forecast.h"
#include "core/plan/plan_search.h"
#include "core/solve/solve.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

std::vector<PlanColor> paperGels() {
  std::vector<PlanColor> colors;
  for (const Rgb& code : {Rgb(218, 131, 102), Rgb(42, 165, 95), Rgb(255, 203, 0), Rgb(0, 38, 96)})
    colors.push_back({"gel" + std::to_string(colors.size() + 1), linearFromSrgb(code / 255.0F)});
  return colors;
}

std::vector<std::string> names(int lights) {
  std::vector<std::string> all{"key", "fill", "back", "kicker"};
  for (int i = 4; i < lights; ++i) all.push_back("light" + std::to_string(i + 1));
  all.resize(size_t(lights));
  return all;
}

PlanSearchOptions planFor(int lights) {
  PlanSearchOptions options;
  options.lights = names(lights);
  return options;
}

/// The plan as a capture, photographed and solved: RMS error of T over the RMS of T.
double measuredError(const LightingMatrix& plan, const SensorNoise& noise, Model model) {
  Capture capture;
  capture.name = "plan";
  capture.noise = noise;
  for (const std::string& name : plan.names) capture.lights.push_back({name, Role::Other, Json::object()});
  for (int k = 0; k < plan.shots; ++k) {
    Shot shot;
    for (int i = 0; i < plan.lights; ++i) shot.lightColors.emplace_back(plan.color(k, i));
    capture.shots.push_back(shot);
  }
  const SyntheticSet truth(plan.lights, 0);
  SolveOptions options;
  options.model = model;
  options.colorUncertainty = 0;
  const SolvedSet set = solve(capture, photograph(capture, truth), options);
  double error = 0;
  double power = 0;
  for (size_t i = 0; i < truth.truth.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < truth.truth[i].pixelCount(); ++p) {
        const double t = truth.truth[i].plane(c)[p];
        error += std::pow(set.contributions[i].plane(c)[p] - t, 2);
        power += t * t;
      }
  return std::sqrt(error / power);
}

double costOf(const LightingMatrix& plan, const PlanSearchOptions& options, int pixelCount) {
  const std::vector<TypicalPixel> pixels = typicalPixels(plan.lights, pixelCount);
  return 0.5 * matteCost(plan, options.noise, pixels) + 0.5 * transportCost(plan, options.noise, pixels);
}

/// The smallest cost of all rotations of different colours, one by one.
double bruteForce(const std::vector<PlanColor>& colors, const PlanSearchOptions& options, int pixelCount) {
  const int lights = int(options.lights.size());
  const int count = int(colors.size());
  double best = std::numeric_limits<double>::infinity();
  std::vector<int> digits(size_t(lights), 0);
  const auto next = [&] {
    for (int& digit : digits) {
      if (++digit < count) return true;
      digit = 0;
    }
    return false;
  };
  do {
    std::vector<int> sorted = digits;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) continue;
    std::vector<int> table;
    for (int k = 0; k < lights; ++k)
      for (int i = 0; i < lights; ++i) table.push_back(digits[size_t((i + k) % lights)]);
    best = std::min(best, costOf(lightingFromIndices(colors, table, options), options, pixelCount));
  } while (next());
  return best;
}

TEST(Plan, FindsTheBestAssignmentOfThePapersGels) {
  const PlanSearchOptions options = planFor(4);
  const PlanChoice choice = searchPlan(paperGels(), options);
  EXPECT_TRUE(choice.exhaustive);
  EXPECT_EQ(choice.plan.shots, 4);
  EXPECT_NEAR(choice.cost, bruteForce(paperGels(), options, 48), 1e-9 * choice.cost);
  // With many more typical pixels than the search looks at the choice is still the best, or as good.
  EXPECT_LT(costOf(choice.plan, options, 512), 1.01 * bruteForce(paperGels(), options, 512));
}

TEST(Plan, TheLocalSearchFindsWhatBruteForceFinds) {
  std::vector<PlanColor> colors = panelColors();
  const PlanChoice choice = searchPlan(colors, [] {
    PlanSearchOptions options = planFor(3);
    options.coding = PlanCoding::Free;  // 19^9 plans
    return options;
  }());
  EXPECT_FALSE(choice.exhaustive);
  const double rotated = bruteForce(colors, planFor(3), 48);
  EXPECT_LE(choice.cost, rotated * (1 + 1e-9));

  colors.resize(12);
  PlanSearchOptions five = planFor(5);  // 12^5 rings, where a colour may come twice
  five.repeat = true;
  const PlanChoice climbed = searchPlan(colors, five);
  EXPECT_FALSE(climbed.exhaustive);
  five.repeat = false;
  const PlanChoice all = searchPlan(colors, five);
  EXPECT_TRUE(all.exhaustive);
  EXPECT_LE(climbed.cost, all.cost * (1 + 1e-9));
}

TEST(Plan, TheSearchIsTheSameEveryTime) {
  PlanSearchOptions options = planFor(4);
  options.coding = PlanCoding::Free;
  EXPECT_EQ(searchPlan(paperGels(), options).colorIndex, searchPlan(paperGels(), options).colorIndex);
}

/// Predicted over measured error of T, for the matte model and for the full contributions.
void expectPrediction(const LightingMatrix& plan, const SensorNoise& noise, const std::string& what) {
  SCOPED_TRACE(what);
  const std::vector<TypicalPixel> pixels = typicalPixels(plan.lights, 1024);
  const double matte = predictedNoise(plan, noise, pixels, Model::Lambert).contribution /
                       measuredError(plan, noise, Model::Lambert);
  const double transport = predictedNoise(plan, noise, pixels, Model::Transport).contribution /
                           measuredError(plan, noise, Model::Transport);
  testing::Test::RecordProperty(what + " matte", std::to_string(matte));
  testing::Test::RecordProperty(what + " transport", std::to_string(transport));
  EXPECT_NEAR(matte, 1, 0.1);
  EXPECT_NEAR(transport, 1, 0.1);
}

TEST(Plan, PredictsTheNoiseThatSolvingMeasures) {
  for (const SensorNoise noise : {SensorNoise{.002, 20000}, SensorNoise{.005, 3000}}) {
    PlanSearchOptions options = planFor(4);
    options.noise = noise;
    expectPrediction(searchPlan(paperGels(), options).plan, noise,
                     "best, full well " + std::to_string(int(noise.fullWell)));
  }
}

TEST(Plan, TheForecastSaysWhatIsNotToldApartAndWhatClips) {
  LightingMatrix same;
  same.shots = same.lights = 2;
  same.names = {"key", "fill"};
  same.colors.assign(4, Rgb(.5F));
  const PlanForecast never = planForecast(same, {.002, 20000});
  EXPECT_TRUE(std::isinf(never.matte.contribution) && std::isinf(never.transport.beta));
  LightingMatrix bright = same;
  bright.colors = {Rgb(9, 0, 1), Rgb(1, 9, 0), Rgb(1, 9, 0), Rgb(9, 0, 1)};
  const PlanForecast clips = planForecast(bright, {.002, 20000});
  EXPECT_TRUE(std::isfinite(clips.matte.contribution));
  ASSERT_FALSE(clips.conditioning.advice.empty());
  EXPECT_THAT(clips.conditioning.advice.back(), testing::HasSubstr("clip"));
}

TEST(Plan, PredictsTheNoiseOfBadPlansToo) {
  const SensorNoise noise{.002, 20000};
  for (const float apart : {.3F, .1F, .03F}) {
    const Rgb a(.5F + apart / 2, .5F, .3F);
    const Rgb b(.5F - apart / 2, .5F + apart / 2, .3F + apart / 2);
    expectPrediction(lightingFromCapture(rotatedCapture(2, {a, b})), noise, std::to_string(apart) + " apart");
  }
  std::vector<Rgb> gels;
  for (const PlanColor& gel : paperGels()) gels.push_back(gel.color);
  do expectPrediction(lightingFromCapture(rotatedCapture(4, gels)), noise, "gels in another order");
  while (std::next_permutation(gels.begin() + 1, gels.end(),
                               [](const Rgb& x, const Rgb& y) { return x.r < y.r; }));
}

TEST(Plan, EveryLightCarriesEachColourOnceInAWholeTurn) {
  const PlanChoice choice = searchPlan(panelColors(), planFor(4));
  for (int a = 0; a < 4; ++a) {
    std::vector<int> ofLight;
    std::vector<int> inShot;
    for (int b = 0; b < 4; ++b) {
      ofLight.push_back(choice.colorIndex[size_t(b) * 4 + size_t(a)]);
      inShot.push_back(choice.colorIndex[size_t(a) * 4 + size_t(b)]);
    }
    EXPECT_THAT(ofLight, testing::UnorderedElementsAreArray(inShot));
    std::sort(inShot.begin(), inShot.end());
    EXPECT_EQ(std::adjacent_find(inShot.begin(), inShot.end()), inShot.end());
  }
}

TEST(Plan, TwiceTheShotsLowerTheNoiseByTheRootOfTwo) {
  std::vector<PlanColor> colors = paperGels();
  colors.resize(3);
  PlanSearchOptions options = planFor(3);
  const PlanChoice once = searchPlan(colors, options);
  options.shots = 6;
  const PlanChoice twice = searchPlan(colors, options);
  EXPECT_EQ(twice.plan.shots, 6);
  EXPECT_NEAR(std::sqrt(once.cost / twice.cost), std::sqrt(2.0), 0.03);
}

Conditioning rotated(const std::vector<Rgb>& colors) {
  const int count = int(colors.size());
  return conditioningOf(lightingFromCapture(rotatedCapture(count, colors)));
}

std::string wordsOf(const Conditioning& conditioning) {
  std::string words;
  for (const std::string& advice : conditioning.advice) words += advice + "\n";
  return words;
}

using testing::HasSubstr;
using testing::Not;

TEST(Plan, LightsOfTheSameColourAreNamed) {
  const Conditioning same = rotated({{.5F, .4F, .3F}, {.5F, .4F, .3F}});
  EXPECT_THAT(wordsOf(same), HasSubstr("light0 and light1 have the same colour in every photograph"));
  EXPECT_TRUE(std::isinf(same.matteAmplification));
  const Conditioning near = rotated({{.5F, .4F, .3F}, {.6F, .35F, .3F}});
  EXPECT_THAT(wordsOf(near), HasSubstr("light0 and light1 are nearly the same colour: the noise of their "
                                       "difference is amplified 15 times; move light1's hue away"));
  const Conditioning dim = rotated({{.02F, .01F, 0}, {0, .01F, .02F}});
  EXPECT_THAT(wordsOf(dim), HasSubstr("are both dim"));
  EXPECT_THAT(wordsOf(dim), Not(HasSubstr("nearly")));
  EXPECT_THAT(wordsOf(rotated({{.9F, .2F, .7F}, {.2F, .9F, .15F}})), "");
}

TEST(Plan, ALightThatIsASumOfOthersIsNamed) {
  LightingMatrix plan{3, 3, {"key", "fill", "back"}, {}};
  for (int k = 0; k < 3; ++k)
    for (const Rgb& color : {Rgb(1, .1F, 0), Rgb(.2F, .7F, .1F), Rgb(.6F, .4F, .05F)})
      plan.colors.push_back(color);
  EXPECT_THAT(wordsOf(conditioningOf(plan)), HasSubstr("key + fill against back: they cannot be separated"));
}

/// In every order each channel has two ones of four: side by side the DFT lacks the highest frequency,
/// opposite the two middle ones.
TEST(Plan, RedGreenBlueAndWhiteAreSingularInEveryChannel) {
  const Conditioning conditioning = rotated({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  for (double amplification : conditioning.amplification) EXPECT_TRUE(std::isinf(amplification));
  EXPECT_THAT(wordsOf(conditioning), HasSubstr("no channel alone can separate the lights"));
  EXPECT_TRUE(std::isfinite(conditioning.matteAmplification));
}

TEST(Plan, SingularValuesOfRotatedColoursAreTheMagnitudesOfTheirDft) {
  const std::vector<Rgb>& colors = defaultColors();
  const Conditioning conditioning = rotated({colors.begin(), colors.begin() + 5});
  for (int c = 0; c < 3; ++c) {
    std::vector<double> magnitudes;
    for (int f = 0; f < 5; ++f) {
      std::complex<double> sum = 0;
      for (int i = 0; i < 5; ++i) sum += std::polar(double(colors[size_t(i)][c]), 2 * M_PI * f * i / 5);
      magnitudes.push_back(std::abs(sum));
    }
    std::sort(magnitudes.rbegin(), magnitudes.rend());
    EXPECT_THAT(conditioning.singularValues[size_t(c)],
                testing::Pointwise(testing::DoubleNear(1e-5), magnitudes));
  }
}

TEST(Plan, AnImpossiblePlanIsRefused) {
  PlanSearchOptions options = planFor(6);
  EXPECT_THROW((void)searchPlan(paperGels(), options), InputError);  // too few colours
  options.repeat = true;
  EXPECT_NO_THROW((void)searchPlan(paperGels(), options));
  options.shots = 2;  // 6 values a pixel for 8 unknowns
  EXPECT_THROW((void)searchPlan(paperGels(), options), InputError);
  EXPECT_THROW((void)searchPlan({{"off", Rgb(0)}, {"off", Rgb(0)}}, planFor(2)), InputError);
  EXPECT_THROW((void)planColorsFromText(".9/.2"), InputError);
  EXPECT_THROW((void)planGelsFromText("L99999"), InputError);
}

}  // namespace
}  // namespace swaplight
