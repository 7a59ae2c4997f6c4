#pragma once

#include "core/set/solve_report.h"

namespace swaplight {

/// How well the lights of the open set are told apart, in a word; a click opens the report behind it.
void drawSolveWord(const SolveReport& report);

}  // namespace swaplight
