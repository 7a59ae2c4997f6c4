// The program `swaplight`: one verb a job.
#include "app/camera_verbs/camera_verbs.h"
#include "app/look_verbs/look_verbs.h"
#include "app/program/heap.h"
#include "app/program/standard_streams.h"
#include "app/session_verbs/session_verbs.h"
#include "app/verbs/verbs.h"

int main(int argc, char** argv) {
  swaplight::keepFreedMemory();
  swaplight::openStandardStreams();
  swaplight::ignoreWriteSignals();
  swaplight::Program program;
  addInfoVerb(program);
  addPlanVerb(program);
  addNewVerb(program);
  addSolveVerb(program);
  addRelightVerb(program);
  addExportVerb(program);
  addReportVerb(program);
  addEvaluateVerb(program);
  addStudioVerb(program);
  addBenchVerb(program);
  addShadowsVerb(program);
  addBetaVerb(program);
  addDoctorVerb(program);
  addLookVerb(program);
  addLightsVerb(program);
  addLightmapVerb(program);
  addNormalsVerb(program);
  addSinksVerb(program);
  addBalanceVerb(program);
  addResponseVerb(program);
  addLinearVerb(program);
  addChartVerb(program);
  addCuesVerb(program);
  addGradeVerb(program);
  addVersionsVerb(program);
  return program.run(argc, argv);
}
