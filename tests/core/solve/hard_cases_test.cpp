#include "core/bench/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/bench/hard_case_error.h"

namespace swaplight {
namespace {

/// What is asked of `auto` in every case.
constexpr double kOverBetter = 1.05;  ///< relative RMSE over that of the better one of lambert and transport
constexpr double kSigmaFrom = 0.90, kSigmaTo = 0.98;  ///< fraction within 2 sigma, in matte cases
/// Where colours hardly differ, shares that would be negative are cut off, and sigma is too large: lambert's
/// by more, auto's just up to the limit. With colours .03 apart eight seeds gave .9803 +- .0011, which one
/// seed meets or misses by how sums are rounded: the limit is on the mean, the test of one seed adds three
/// times its scatter.
constexpr double kSigmaOfLambertTo = 0.995;
constexpr double kScatterOfSeeds = 0.0033;

/// All in one, because the suite takes half a minute.
TEST(HardCases, AutoIsAsGoodAsTheBestModelNothingIsNaNAndSigmaIsHonest) {
  double ours = 0;
  double published = 0;
  for (int i = 0; i < int(hardCaseNames().size()); ++i) {
    const HardCaseError row = measureHardCase(makeHardCase(i, 1));
    SCOPED_TRACE(row.name);
    for (const HardCaseError::Answer& answer : row.answers)
      EXPECT_EQ(answer.error.notFinite, 0U) << answer.model;

    const SolutionError& best = *row.find("auto");
    const SolutionError& lambert = *row.find("lambert");
    const double better = std::min(lambert.relativeRmse, row.find("transport")->relativeRmse);
    EXPECT_LE(best.relativeRmse, kOverBetter * better);

    if (row.matte) {
      EXPECT_GE(best.withinTwoSigma, kSigmaFrom);
      EXPECT_LE(best.withinTwoSigma, kSigmaTo + kScatterOfSeeds);
      EXPECT_GE(lambert.withinTwoSigma, kSigmaFrom);
      EXPECT_LE(lambert.withinTwoSigma, kSigmaOfLambertTo);
    }
    if (const SolutionError* old = row.find("published"))
      ours += best.deltaEMean, published += old->deltaEMean;
  }
  EXPECT_LE(ours, 0.66 * published);
}

TEST(HardCases, HaveNamesOfTheirOwnAndTruthsThatLightsCanHave) {
  std::set<std::string> names;
  for (int i = 0; i < int(hardCaseNames().size()); ++i) {
    const HardCase made = makeHardCase(i, 1, 24);
    SCOPED_TRACE(made.name);
    EXPECT_TRUE(names.insert(made.name).second);
    ASSERT_EQ(int(made.truth.size()), made.capture.lightCount());
    EXPECT_EQ(int(made.pixels.shots.size()), made.capture.shotCount());
    for (const Image& t : made.truth)
      for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(std::all_of(t.plane(c), t.plane(c) + t.pixelCount(),
                                [](float value) { return std::isfinite(value) && value >= 0; }));
  }
}

HardCase named(const std::string& name, unsigned seed = 1) {
  const std::vector<std::string> names = hardCaseNames();
  return makeHardCase(int(std::find(names.begin(), names.end(), name) - names.begin()), seed, 96);
}

double fractionBeyond(const HardCase& made, float level) {
  size_t count = 0;
  const size_t pixels = made.truth.front().pixelCount();
  for (size_t p = 0; p < pixels; ++p) {
    bool beyond = false;
    for (const Image& shot : made.pixels.shots)
      for (int c = 0; c < 3; ++c) beyond |= shot.plane(c)[p] >= level;
    count += beyond;
  }
  return double(count) / double(pixels);
}

TEST(HardCases, AreWhatTheirNamesSay) {
  EXPECT_NEAR(fractionBeyond(named("clipped 1 %"), 1), .01, .003);
  EXPECT_NEAR(fractionBeyond(named("clipped 10 %"), 1), .1, .01);
  EXPECT_NEAR(fractionBeyond(named("usual"), .9F), .005, .003);
  EXPECT_GT(fractionBeyond(named("radiance 10000"), 5000), 0);

  const HardCase still = named("usual");
  const HardCase wrong = named("colours wrong by 5 %");
  EXPECT_EQ(std::count(still.pixels.shots[0].plane(0), still.pixels.shots[0].plane(0) + 100,
                       wrong.pixels.shots[0].plane(0)[50]),
            1)
      << "only what the solver is told differs";
  EXPECT_NE(still.capture.shots[0].lightColors, wrong.capture.shots[0].lightColors);

  const HardCase bits = named("10-bit linear");
  for (int x = 0; x < 96; ++x) {
    const float code = 1023 * bits.pixels.shots[1].plane(2)[x];
    EXPECT_NEAR(code, std::round(code), 1e-3);
  }
  EXPECT_EQ(named("camera moved 2 pixels, aligned").options.align, Remedy::On);
}

TEST(HardCases, TheSameSeedGivesTheSameNoise) {
  const HardCase a = named("usual");
  const HardCase b = named("usual");
  const HardCase c = named("usual", 2);
  EXPECT_EQ(a.pixels.shots[1].plane(1)[77], b.pixels.shots[1].plane(1)[77]);
  EXPECT_NE(a.pixels.shots[1].plane(1)[77], c.pixels.shots[1].plane(1)[77]);
}

}  // namespace
}  // namespace swaplight
