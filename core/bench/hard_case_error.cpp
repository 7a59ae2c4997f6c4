#include "core/bench/hard_case_error.h"

#include "core/bench/bench_truth.h"
#include "core/solve/solve.h"

namespace swaplight {

const SolutionError* HardCaseError::find(const std::string& model) const {
  for (const Answer& answer : answers)
    if (answer.model == model) return &answer.error;
  return nullptr;
}

std::vector<std::string> hardCaseModels() {
  return {"published", "lambert", "gloss", "transport", "auto"};
}

HardCaseError measureHardCase(const HardCase& test) {
  const LightingMatrix lighting = lightingFromCapture(test.capture);
  const BoundedTruth truth(benchTruth(test.capture, test.truth), lighting, test.noise,
                           test.pixels.clipLevel.front());
  HardCaseError row{test.name, test.group, test.matte, test.mixed, truth.relativeBound, {}};
  for (const std::string& model : hardCaseModels()) {
    SolveOptions options = test.options;
    if (model != "published") {
      options.model = modelFromName(model);
    } else {
      if (lighting.lights != 2 || lighting.shots != 2) continue;
      options.solver = model;
    }
    row.answers.push_back({model, compareSolution(solve(test.capture, test.pixels, options), truth)});
  }
  return row;
}

}  // namespace swaplight
