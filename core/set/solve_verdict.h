#pragma once

#include <string>
#include <vector>

#include "core/set/solve_report.h"

namespace swaplight {

/// One honest word about a solve: how well its lights are told apart.
struct SolveVerdict {
  enum class Word { Good, Fair, NotApart };  // the worse the later
  Word word = Word::Good;
  std::vector<std::string> reasons;  ///< what stands in the way, the gravest first, with what to do about it
};

/// The worst of three figures of the solver: the standard error of contributions in the median pixel, which
/// holds the photographs' noise and how alike the colours are; how wrong the colours are taken to be; and
/// what they leave of the light unexplained (the last two not where every light was photographed alone); and
/// of the share of pixels that are no numbers in too many photographs. No more than fair where a cause of a
/// misfit was found, much of the picture moved, or no light has one of the channels. The reasons are taken
/// from the report's other figures. It cannot tell colours that are wrong and fit: two lights exchanged
/// everywhere, say. A report without the figures (of another program) gives fair, and says so.
[[nodiscard]] SolveVerdict verdictOf(const SolveReport& report);

/// "good", "fair", "lights not apart".
[[nodiscard]] const char* verdictWord(SolveVerdict::Word word);

/// "Lights told apart: fair. The colours of ... ." in one line.
[[nodiscard]] std::string verdictLine(const SolveVerdict& verdict);

}  // namespace swaplight
