#include "core/bench/solver_error.h"

#include <chrono>

#include "core/bench/bench_truth.h"
#include "core/bench/hard_cases.h"
#include "core/solve/model/estimator.h"
#include "core/solve/solve.h"

namespace swaplight {

bool fitsCapture(const EstimatorInfo& info, int lights, int shots) {
  const bool twoOnly = info.name == "brute-force" || info.name == "published" || info.name == "closed-form";
  return !twoOnly || (lights == 2 && shots == 2);
}

std::vector<SolverError> measureSolverError(Capture capture, unsigned seed, const Progress& progress) {
  const HardCase test = hardCaseOfCapture(std::move(capture), seed);
  const LightingMatrix lighting = lightingFromCapture(test.capture);
  const BoundedTruth truth(benchTruth(test.capture, test.truth), lighting, test.noise,
                           test.pixels.clipLevel.front());
  std::vector<SolverError> rows;
  for (const EstimatorInfo& info : estimators()) {
    if (!fitsCapture(info, lighting.lights, lighting.shots)) continue;
    progress.update(float(rows.size()) / float(estimators().size()), std::string(info.name));
    SolveOptions options;
    options.solver = std::string(info.name);
    const auto start = std::chrono::steady_clock::now();
    const SolvedSet set = solve(test.capture, test.pixels, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rows.push_back({test.name, std::string(info.name), compareSolution(set, truth), seconds});
  }
  return rows;
}

}  // namespace swaplight
