#include "core/set/solve_verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

/// Up to here a figure is good, and fair.
struct Limits {
  double good, fair;
};
// Chosen on tests/samples/three_point and film_set, whose colours were told rightly and in six wrong ways;
// docs/solve.md has that table, and the sets that it was checked on.
constexpr Limits kError{0.12, 0.35};       ///< the median pixel's standard error, over its light
constexpr Limits kColorError{0.18, 0.45};  ///< how wrong the colours are taken to be
constexpr Limits kUnexplained{0.1, 0.2};   ///< of the light in bright pixels, by the colours as told
constexpr Limits kLost{0.05, 0.3};         ///< of the pixels: SolveReport::lost
/// Lights that every channel tells apart like one lamp at a time need no surface to be matte: what that
/// leaves unexplained says nothing of the colours.
constexpr double kOneByOne = 1.1;
/// The photographs' noise that a model leaves of them, which is not good any more: matte models, transport
/// and auto leave .3 to 1.5 of good sets, a model that does not fit (single) 4 to 35.
constexpr double kManyNoises = 3;
// What is worth naming as a reason, by judgement: but for what moved it chooses words, never the verdict.
constexpr double kMuchAmplified = 2;  ///< noise of the matte model over that of a photograph
constexpr double kManyPixels = 0.05;  ///< clipped, too dark or moved

double partOf(const SolveReport& report, size_t pixels) {
  return report.pixels > 0 ? static_cast<double>(pixels) / static_cast<double>(report.pixels) : 0;
}

bool isOneByOne(const SolveReport& report) {
  return std::all_of(report.conditioning.amplification.begin(), report.conditioning.amplification.end(),
                     [](double times) { return times > 0 && times <= kOneByOne; });
}

/// No photograph shows one of the channels: no new light brings it back.
bool lacksChannel(const SolveReport& report) {
  return std::any_of(report.conditioning.singularValues.begin(), report.conditioning.singularValues.end(),
                     [](const std::vector<double>& of) { return !of.empty() && of.front() <= 0; });
}

using Word = SolveVerdict::Word;

Word wordOf(double figure, const Limits& limits) {
  if (figure > limits.fair) return Word::NotApart;
  return figure > limits.good ? Word::Fair : Word::Good;
}

/// What the light in bright pixels says of the colours as told, of matte surfaces.
Word matteWord(const SolveReport& report) {
  return std::max(wordOf(static_cast<double>(report.colorUncertainty), kColorError),
                  wordOf(report.colorDisagreement, kUnexplained));
}

Word colorWord(const SolveReport& report) {
  return isOneByOne(report) ? Word::Good : matteWord(report);
}

void addColorReasons(const SolveReport& report, std::vector<std::string>& reasons) {
  if (const std::string words = wordsFor(report.causes, {!report.shifts.empty(), report.tone.has_value()});
      !words.empty())
    reasons.push_back(words);
  for (const std::string& advice : report.conditioning.advice) reasons.push_back(advice);
  if (report.openColor && !report.openColor->settled)
    reasons.push_back(fmt::format("the photographs leave one number of {} open", report.openColor->name));
  if (isOneByOne(report) && matteWord(report) == Word::NotApart)
    reasons.emplace_back(
        "the photographs differ in colour more than one white lamp in each explains: was only one lit at a "
        "time, and without gels?");
  if (colorWord(report) != Word::Good)
    reasons.push_back(fmt::format(
        "the colours as told leave {:.0f} % of the light unexplained: check which light had which gel",
        100 * std::min(1.0, report.colorDisagreement)));
  if (report.conditioning.advice.empty() && report.conditioning.matteAmplification > kMuchAmplified)
    reasons.push_back(fmt::format(
        "the lights' colours are much alike, which amplifies noise {:.1f} times: take stronger gels",
        report.conditioning.matteAmplification));
}

void addPictureReasons(const SolveReport& report, std::vector<std::string>& reasons) {
  if (!std::isfinite(report.sigmaMedian) && partOf(report, report.lost) <= kManyPixels)
    reasons.emplace_back(
        "the photographs hold no light: check the files, and which is named as dark or ambient");
  if (report.residualMedian > kManyNoises)
    reasons.push_back(
        fmt::format("the photographs disagree with each other by {:.1f} times their noise: did anything "
                    "move, or does the "
                    "model not fit?",
                    report.residualMedian));
  const auto many = [&](size_t pixels, const char* words) {
    if (const double part = partOf(report, pixels); part > kManyPixels)
      reasons.push_back(fmt::format("{:.0f} % of the pixels {}", 100 * part, words));
  };
  many(report.moved, report.shifts.empty()
                         ? "moved between the photographs: align them"
                         : "moved between the photographs, and registering has not ended it: "
                           "take them again");
  many(report.lost,
       "are no numbers, infinite or negative in too many photographs: check the files, and which is named as "
       "dark or ambient");
  many(report.clipped, "are clipped in a photograph: expose less");
  // Under wrong colours what is known of a pixel is less than its light, as where it is dark.
  if (matteWord(report) != Word::NotApart) many(report.tooDark, "are too dark: expose more");
}

}  // namespace

SolveVerdict verdictOf(const SolveReport& report) {
  SolveVerdict verdict;
  if (report.pixels == 0)
    return {SolveVerdict::Word::Fair, {"the report does not say how well the lights are known"}};
  verdict.word = std::max(wordOf(report.sigmaMedian, kError), colorWord(report));
  // Sigma knows noise and colours, no other cause: what explains much of the misfit is not good.
  const bool muchMoved = partOf(report, report.moved) > kManyPixels;
  if (!report.causes.likely.empty() || report.causes.unnamed || muchMoved || lacksChannel(report) ||
      report.residualMedian > kManyNoises)
    verdict.word = std::max(verdict.word, SolveVerdict::Word::Fair);
  verdict.word = std::max(verdict.word, wordOf(partOf(report, report.lost), kLost));
  if (verdict.word == SolveVerdict::Word::Good) return verdict;
  addColorReasons(report, verdict.reasons);
  addPictureReasons(report, verdict.reasons);
  if (verdict.reasons.empty()) verdict.reasons.emplace_back("the photographs are noisy: expose more");
  return verdict;
}

const char* verdictWord(SolveVerdict::Word word) {
  switch (word) {
    case SolveVerdict::Word::Good:
      return "good";
    case SolveVerdict::Word::Fair:
      return "fair";
    case SolveVerdict::Word::NotApart:
      break;
  }
  return "lights not apart";
}

std::string verdictLine(const SolveVerdict& verdict) {
  const std::string word = verdictWord(verdict.word);
  if (verdict.reasons.empty()) return fmt::format("Lights told apart: {}.", word);
  const std::string why = fmt::format("{}", fmt::join(verdict.reasons, "; "));
  return verdict.word == SolveVerdict::Word::NotApart ? fmt::format("Lights not apart: {}.", why)
                                                      : fmt::format("Lights told apart: {}: {}.", word, why);
}

}  // namespace swaplight
