#pragma once

#include "app/program/program.h"

namespace swaplight {

// One file a verb: each adds itself, its options and what it does to the program.

void addInfoVerb(Program& program);
void addSolveVerb(Program& program);
void addRelightVerb(Program& program);
void addExportVerb(Program& program);
void addReportVerb(Program& program);
void addEvaluateVerb(Program& program);
void addStudioVerb(Program& program);
void addBenchVerb(Program& program);
void addPlanVerb(Program& program);
void addNewVerb(Program& program);
void addShadowsVerb(Program& program);
void addSinksVerb(Program& program);
void addBetaVerb(Program& program);
void addDoctorVerb(Program& program);
void addLightmapVerb(Program& program);
void addNormalsVerb(Program& program);
void addLightsVerb(Program& program);
void addBalanceVerb(Program& program);
void addCuesVerb(Program& program);

}  // namespace swaplight
