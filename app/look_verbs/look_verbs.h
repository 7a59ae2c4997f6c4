#pragma once

#include "app/program/program.h"

namespace swaplight {

// `swaplight look` and its actions; see app/verbs/verbs.h for the other verbs.

void addLookVerb(Program& program);

}  // namespace swaplight
