#include "core/set/solve_verdict.h"

#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace swaplight {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Word = SolveVerdict::Word;

SolveReport reportWith(double error) {
  SolveReport report;
  report.pixels = 1000;
  report.sigmaMedian = error;
  return report;
}

std::string reasonsOf(const SolveReport& report) {
  return fmt::format("{}", fmt::join(verdictOf(report).reasons, "; "));
}

TEST(SolveVerdict, FollowsFromTheErrorOfTheMedianPixel) {
  EXPECT_EQ(verdictOf(reportWith(0)).word, Word::Good);
  EXPECT_EQ(verdictOf(reportWith(0.11)).word, Word::Good);
  EXPECT_EQ(verdictOf(reportWith(0.2)).word, Word::Fair);
  EXPECT_EQ(verdictOf(reportWith(0.5)).word, Word::NotApart);
  EXPECT_EQ(verdictOf(reportWith(INFINITY)).word, Word::NotApart);
}

TEST(SolveVerdict, PixelsThatAreNoNumbersAreNotToldApart) {
  SolveReport report = reportWith(0.01);
  for (const auto& [broken, word] :
       {std::pair(size_t{40}, Word::Good), {size_t{100}, Word::Fair}, {size_t{900}, Word::NotApart}}) {
    report.lost = broken;
    EXPECT_EQ(verdictOf(report).word, word) << broken;
  }
  EXPECT_THAT(verdictLine(verdictOf(report)), HasSubstr("90 % of the pixels are no numbers"));
  EXPECT_THAT(verdictLine(verdictOf(reportWith(INFINITY))), HasSubstr("hold no light"));
  SolveReport recovered = reportWith(0.01);
  recovered.notFinite = 900;  // of one photograph: the others sufficed
  EXPECT_EQ(verdictOf(recovered).word, Word::Good);
}

TEST(SolveVerdict, AGoodOneGivesNoReasons) {
  SolveReport report = reportWith(0.02);
  report.colorDisagreement = 0.08;
  report.clipped = 500;
  EXPECT_THAT(verdictOf(report).reasons, IsEmpty());
  EXPECT_EQ(verdictLine(verdictOf(report)), "Lights told apart: good.");
}

TEST(SolveVerdict, ColoursThatTheLightContradictsAreNotGood) {
  SolveReport report = reportWith(0.02);
  report.conditioning.amplification = {1.2, 1.5, 1.2};
  for (const auto& [uncertainty, word] :
       {std::pair(0.15F, Word::Good), {0.3F, Word::Fair}, {0.6F, Word::NotApart}}) {
    report.colorUncertainty = uncertainty;
    EXPECT_EQ(verdictOf(report).word, word) << uncertainty;
  }
  report.colorUncertainty = 0.12F;
  report.colorDisagreement = 0.36;  // two photographs of real gels under quite other colours than were told
  EXPECT_EQ(verdictOf(report).word, Word::NotApart);
}

TEST(SolveVerdict, LampsPhotographedOneByOneNeedNoMatteSurface) {
  SolveReport report = reportWith(0.02);
  report.conditioning.amplification = {1, 1, 1};
  report.colorUncertainty = 0.6F;
  report.colorDisagreement = 0.6;
  EXPECT_EQ(verdictOf(report).word, Word::Good);
}

/// Gels that were told to be one white lamp at a time: nothing is dark, but what was told is wrong.
TEST(SolveVerdict, LampsThatWereNotLitOneByOneAreAskedFor) {
  SolveReport report = reportWith(0.6);
  report.conditioning.amplification = {1, 1, 1};
  report.colorUncertainty = 2.28F;
  report.colorDisagreement = 0.95;
  report.tooDark = report.pixels;
  const std::string reasons = reasonsOf(report);
  EXPECT_NE(reasons.find("was only one lit at a time"), std::string::npos) << reasons;
  EXPECT_EQ(reasons.find("too dark"), std::string::npos) << reasons;
}

TEST(SolveVerdict, DarkPhotographsAreNamedBesideColoursThatFitLess) {
  SolveReport report = reportWith(0.2);
  report.colorDisagreement = 0.11;
  report.tooDark = report.pixels / 3;
  const std::string reasons = reasonsOf(report);
  EXPECT_NE(reasons.find("too dark: expose more"), std::string::npos) << reasons;
}

TEST(SolveVerdict, PhotographsThatTheModelDoesNotExplainAreNotGood) {
  SolveReport report = reportWith(0.01);
  report.residualMedian = 1.5;
  EXPECT_EQ(verdictOf(report).word, Word::Good);
  report.residualMedian = 30;
  EXPECT_EQ(verdictOf(report).word, Word::Fair);
}

TEST(SolveVerdict, ASetOfWhichMuchMovedIsNotGood) {
  SolveReport report = reportWith(0.02);
  report.moved = 40;
  EXPECT_EQ(verdictOf(report).word, Word::Good);
  report.moved = 120;
  EXPECT_EQ(verdictOf(report).word, Word::Fair);
  EXPECT_THAT(verdictLine(verdictOf(report)),
              HasSubstr("12 % of the pixels moved between the photographs: align"));
  report.shifts = {{}, {0, 0, false}};
  EXPECT_THAT(verdictLine(verdictOf(report)), HasSubstr("take them again"));
}

TEST(SolveVerdict, WhatWasTriedIsNotAdvisedAgain) {
  SolveReport report = reportWith(0.02);
  report.causes.all = {{Cause::Moved, .4, .3, 8, 0, .5}};
  report.causes.likely = {Cause::Moved};
  EXPECT_THAT(verdictLine(verdictOf(report)), HasSubstr("--align on"));
  report.shifts = {{}, {1, 0}};
  EXPECT_THAT(verdictLine(verdictOf(report)), Not(HasSubstr("--align on")));
  EXPECT_THAT(verdictLine(verdictOf(report)), HasSubstr("registering them"));
}

TEST(SolveVerdict, ASetWithoutGreenIsNotGood) {
  SolveReport report = reportWith(0.02);
  report.conditioning.singularValues = {{{1, 1}, {0.5, 0.1}, {1, 1}}};
  EXPECT_EQ(verdictOf(report).word, Word::Good);
  report.conditioning.singularValues[1] = {0, 0};
  report.conditioning.advice = {"no light has green: the set's green is not recorded"};
  EXPECT_EQ(verdictLine(verdictOf(report)),
            "Lights told apart: fair: no light has green: the set's green is not recorded.");
}

TEST(SolveVerdict, SaysWhyAndWhatToDo) {
  SolveReport report = reportWith(0.6);
  report.colorDisagreement = 0.502;
  report.colorUncertainty = 1.2F;
  report.clipped = 200;
  EXPECT_THAT(verdictLine(verdictOf(report)), testing::AllOf(HasSubstr("Lights not apart: "),
                                                             HasSubstr("leave 50 % of the light unexplained"),
                                                             HasSubstr("20 % of the pixels are clipped")));
  report = reportWith(0.2);
  EXPECT_EQ(verdictLine(verdictOf(report)),
            "Lights told apart: fair: the photographs are noisy: expose more.");
  report.conditioning.matteAmplification = 4;
  EXPECT_THAT(verdictOf(report).reasons, testing::ElementsAre(HasSubstr("amplifies noise 4.0 times")));
  report.conditioning.advice = {"key and fill have the same colour in every photograph"};
  EXPECT_THAT(verdictOf(report).reasons, testing::ElementsAre(HasSubstr("key and fill have the same")));
}

TEST(SolveVerdict, KnowsNothingOfAReportWithoutPixels) {
  const SolveVerdict verdict = verdictOf({});
  EXPECT_EQ(verdict.word, Word::Fair);
  EXPECT_FALSE(verdict.reasons.empty());
}

}  // namespace
}  // namespace swaplight
