#pragma once

#include "app/program/program.h"

namespace swaplight {

// Verbs about what a camera does to light; see app/verbs/verbs.h for all others.

void addResponseVerb(Program& program);
void addLinearVerb(Program& program);
void addChartVerb(Program& program);

}  // namespace swaplight
