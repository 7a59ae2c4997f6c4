#include "core/set/solve_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/json.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Every field away from its default.
SolveReport fullReport() {
  SolveReport report;
  report.message = "Two lights told apart.";
  report.model = "auto";
  report.solver = "shrinkage";
  report.noise = {0.0021, 20000};
  report.noiseGiven = true;
  report.colorUncertainty = 0.013F;
  report.colorDisagreement = 0.25;
  report.colorChange = 0.5;
  report.refinedColors = {{1, 0.1F, 0}, {0, 0.7F, 1}};
  report.estimated = {"The colour of key was not known"};
  report.openColor =
      OpenColor{"?a", Rgb(.1F, .2F, .3F), Rgb(.4F, .5F, .6F), Rgb(.2F), .25F, Rgb(2), "grey", true};
  report.conditioning.singularValues = {{{2, 1}, {3, 0.5}, {1, 0}}};
  report.conditioning.condition = {2, 6, std::numeric_limits<double>::infinity()};
  report.conditioning.amplification = {1.1, 2.2, std::numeric_limits<double>::infinity()};
  report.conditioning.matteAmplification = 1.5;
  report.conditioning.advice = {"two lights share a colour"};
  report.shifts = {{}, {1.5F, -0.25F}, {0, 0, false}};
  report.shifts[1].turn = .01F, report.shifts[1].zoom = 1.002F;
  report.residualMedian = 1.25;
  report.sigmaMedian = 0.01;
  report.pixels = 4800;
  report.clipped = 1, report.tooDark = 2, report.moved = 3, report.notFinite = 4, report.filled = 5;
  report.seconds = 0.75;
  report.causes.all = {{Cause::Moved, .4, .3, 6, 0, .8}, {Cause::Field, .2, .1, 4, 3, .02}};
  report.causes.likely = {Cause::Moved};
  report.tone = TakenTone{1.25, {{.5F, .4F}, {1, 1}}};
  report.warnings = {"shot 2 was not registered"};
  report.options = Json{{"model", "auto"}, {"align", true}};
  report.unknown = Json{{"of_a_newer_version", {1, 2}}};
  return report;
}

TEST(SolveReport, ComesBackFromItsJsonWithEveryField) {
  const Json written = jsonFromSolveReport(fullReport());
  const SolveReport back = solveReportFromJson(Json::parse(written.dump()), "report");
  EXPECT_EQ(jsonFromSolveReport(back).dump(), written.dump());
  EXPECT_EQ(back.notFinite, 4U);
  EXPECT_TRUE(back.noiseGiven);
  EXPECT_TRUE(std::isinf(back.conditioning.condition[2]));
  EXPECT_FALSE(back.shifts[2].found);
  EXPECT_TRUE(back.causes.is(Cause::Moved));
  EXPECT_EQ(back.causes.all.back().behind, 3);
  EXPECT_EQ(back.tone->exponent, 1.25);
  EXPECT_EQ(back.shifts[1].y, -0.25F);
  EXPECT_NEAR(back.shifts[1].turn, .01F, 1e-7);
  EXPECT_EQ(back.shifts[1].zoom, 1.002F);
  EXPECT_FALSE(back.shifts[0].isTurned());
  EXPECT_THAT(back.warnings, ElementsAre("shot 2 was not registered"));
  EXPECT_EQ(back.unknown.json().dump(), R"({"of_a_newer_version":[1,2]})");
}

TEST(SolveReport, WhatIsMissingIsAtItsDefault) {
  const SolveReport report = solveReportFromJson(Json{{"model", "lambert"}}, "report");
  EXPECT_EQ(report.model, "lambert");
  EXPECT_FALSE(report.noiseGiven);
  EXPECT_EQ(report.noise, SensorNoise{});
  EXPECT_TRUE(report.unknown.empty());
}

TEST(SolveReport, SaysWhatIsOfAnotherKindThanExpected) {
  const auto error = [](const char* text) {
    return inputError([&] { (void)solveReportFromJson(Json::parse(text), "a.exr"); });
  };
  EXPECT_THAT(error(R"({"message": 3})"), HasSubstr("a.exr: \"message\" is the number 3, expected a text"));
  EXPECT_THAT(error(R"({"warnings": [1]})"), HasSubstr("expected texts"));
  EXPECT_THAT(error(R"({"shifts": [[1, "a"]]})"), HasSubstr("a list of 2 numbers"));
  EXPECT_THAT(error(R"({"refined_colors": [[1, 2]]})"), HasSubstr("a list of 3 numbers"));
  EXPECT_THAT(error(R"({"pixels": -1})"), HasSubstr("pixels"));
}

}  // namespace
}  // namespace swaplight
