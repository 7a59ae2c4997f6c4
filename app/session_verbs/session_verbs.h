#pragma once

#include "app/program/program.h"

namespace swaplight {

// Verbs about a session as a whole; see app/verbs/verbs.h for all others.

void addGradeVerb(Program& program);
void addVersionsVerb(Program& program);

}  // namespace swaplight
