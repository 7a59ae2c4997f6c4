#include "core/bench/solver_speed.h"

#include "core/base/parallel.h"
#include "core/bench/timed_solver.h"

namespace swaplight {

std::vector<SolverSpeed> measureSolverSpeed(const SolverSpeedOptions& options, const Progress& progress) {
  std::vector<SolverSpeed> rows;
  const int before = threadCount();
  const double steps = double(options.lights.size() * options.threads.size());
  double done = 0;
  for (int lights : options.lights) {
    const BenchScene matte = makeBenchScene(options.width, options.height, lights, 0.02F);
    const BenchScene lit = makeLitScene(options.width, options.height, lights);
    const BenchScene glossy = makeBenchScene(options.width, options.height, lights, 0.15F);
    SolvedSet set = roomFor(matte);
    for (int threads : options.threads) {
      progress.update(float(done++ / steps), fmt::format("{} lights, {} threads", lights, threads));
      setThreads(threads);
      const double brute = lights == 2 ? bruteForceSpeed(matte, set, options.seconds) : 0;
      if (brute > 0) rows.push_back({"brute-force", lights, threads, brute, 0, 1});
      const auto add = [&](const std::string& solver, const std::string& name, const BenchScene& scene,
                           bool beta) {
        const double limit = memorySpeed(scene, set, beta, options.seconds);
        const double speed = estimatorSpeed(solver, scene, set, beta, options.seconds);
        rows.push_back({name, lights, threads, speed, limit, brute > 0 ? speed / brute : 0});
      };
      if (lights == 2) add("closed-form", "closed-form", matte, false);
      add("demultiplex", "demultiplex + beta", matte, true);
      add("demultiplex", "demultiplex + beta, nothing negative", lit, true);
      add("nnls", "nnls + beta, nothing negative", lit, true);
      add("nnls", "nnls + beta", matte, true);
      add("maximum-likelihood", "maximum-likelihood", matte, true);
      add("auto", "auto, mostly matte", matte, true);
      add("auto", "auto, glossy", glossy, true);
    }
  }
  setThreads(before);
  return rows;
}

}  // namespace swaplight
