#include <filesystem>
#include <map>

#include "app/verbs/bench_hard_cases.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/bench/solver_error.h"
#include "core/bench/solver_speed.h"
#include "core/bench/trade_off.h"
#include "core/file/atomic_file.h"
#include "core/image/io/image_format.h"
#include "core/image/io/image_io.h"
#include "core/ocio/chosen_config.h"
#include "core/plot/plot.h"

namespace swaplight {
namespace {

struct BenchCommand {
  std::vector<std::string> captures;
  std::string output;
  bool noSpeed = false;
  bool quick = false;
  bool hardCases = false;
  bool tradeOff = false;
  unsigned seed = 1;
};

constexpr const char* kNotMeasured =
    "Not measured: reading and writing files, the time of the first solve after the start, real photographs "
    "(their "
    "truth is not known), colours that are wrong.\n";

std::string speedTable(const std::vector<SolverSpeed>& rows) {
  std::string text = fmt::format("{:<24}{:>7}{:>9}{:>12}{:>14}{:>16}\n", "solver", "lights", "threads",
                                 "MPix/s", "of the limit", "brute force x");
  for (const SolverSpeed& row : rows)
    text +=
        fmt::format("{:<24}{:>7}{:>9}{:>12.1f}{:>14}{:>16}\n", row.solver, row.lights, row.threads,
                    row.megapixels, row.limit > 0 ? fmt::format("{:.2f}", row.megapixels / row.limit) : "",
                    row.againstBruteForce > 0 ? fmt::format("{:.0f}", row.againstBruteForce) : "");
  return text;
}

std::string errorTable(const std::vector<SolverError>& rows) {
  std::string text = fmt::format("{:<16}{:<20}{:>10}{:>14}{:>12}{:>10}{:>10}\n", "capture", "solver",
                                 "rel RMSE", "beta / bound", "mean dE00", "p95 dE00", "seconds");
  for (const SolverError& row : rows)
    text += fmt::format("{:<16}{:<20}{:>10.4f}{:>14.2f}{:>12.2f}{:>10.2f}{:>10.3f}\n", row.capture,
                        row.solver, row.error.relativeRmse, row.error.betaOverBound, row.error.deltaEMean,
                        row.error.deltaE95, row.seconds);
  return text;
}

Json jsonOf(const std::vector<SolverSpeed>& speeds, const std::vector<SolverError>& errors) {
  Json json{{"speed", Json::array()}, {"error", Json::array()}};
  for (const SolverSpeed& row : speeds)
    json["speed"].push_back({{"solver", row.solver},
                             {"lights", row.lights},
                             {"threads", row.threads},
                             {"megapixels_per_second", row.megapixels},
                             {"limit_megapixels_per_second", row.limit},
                             {"times_brute_force", row.againstBruteForce}});
  for (const SolverError& row : errors)
    json["error"].push_back({{"capture", row.capture},
                             {"solver", row.solver},
                             {"rel_rmse", row.error.relativeRmse},
                             {"beta_rmse_over_bound", row.error.betaOverBound},
                             {"de_mean", row.error.deltaEMean},
                             {"de_p95", row.error.deltaE95},
                             {"within_two_sigma", row.error.withinTwoSigma},
                             {"seconds", row.seconds}});
  return json;
}

std::string tradeOffTable(const std::vector<TradeOff>& rows) {
  std::vector<std::vector<std::string>> cells{
      {"solver", "lights", "surfaces", "MPix/s", "of the limit", "rel RMSE", "mean dE00"}};
  for (const TradeOff& row : rows)
    cells.push_back({row.solver, std::to_string(row.lights), row.glossy ? "glossy" : "matte",
                     fmt::format("{:.1f}", row.megapixels), fmt::format("{:.2f}", row.megapixels / row.limit),
                     fmt::format("{:.4f}", row.relativeRmse), fmt::format("{:.2f}", row.deltaE)});
  return tableText(cells);
}

Json jsonOf(const std::vector<TradeOff>& rows) {
  Json json{{"trade_off", Json::array()}};
  for (const TradeOff& row : rows)
    json["trade_off"].push_back({{"solver", row.solver},
                                 {"lights", row.lights},
                                 {"glossy", row.glossy},
                                 {"megapixels_per_second", row.megapixels},
                                 {"limit_megapixels_per_second", row.limit},
                                 {"rel_rmse", row.relativeRmse},
                                 {"de_mean", row.deltaE}});
  return json;
}

/// Error against cost of a whole solve, a series a capture.
Image paretoPlot(const std::vector<SolverError>& rows) {
  ScatterPlot plot;
  plot.title = "Error against cost";
  plot.x = {.label = "seconds a solve", .log = true, .low = {}, .high = {}};
  plot.y = {.label = "mean CIEDE2000 of a relit frame", .log = true, .low = {}, .high = {}};
  std::map<std::string, ScatterPlot::Series> series;
  for (const SolverError& row : rows) {
    ScatterPlot::Series& points = series[row.capture];
    points.name = row.capture;
    points.x.push_back(row.seconds);
    points.y.push_back(row.error.deltaEMean);
    points.labels.push_back(row.solver);
  }
  for (auto& [name, points] : series) plot.series.push_back(std::move(points));
  return drawScatterPlot(plot);
}

int run(const BenchCommand& arguments, Terminal& terminal) {
  const Progress progress = terminal.progress();
  if (arguments.hardCases && arguments.tradeOff)
    throw InputError("--hard-cases and --trade-off: give one of them");
  if (arguments.tradeOff && !arguments.captures.empty())
    throw InputError("--trade-off: has a scene of its own; leave out {}", arguments.captures.front());
  if (!arguments.output.empty()) {
    if (arguments.hardCases || (!arguments.tradeOff && arguments.captures.empty()))
      throw InputError("-o {}: a picture is drawn of captures, or with --trade-off; leave it out",
                       arguments.output);
    static_cast<void>(imageFormatForWriting(arguments.output));
    checkWritable(arguments.output);
  }
  if (arguments.hardCases) {
    const Description suite = benchHardCases(arguments.captures, arguments.seed, arguments.quick, progress);
    terminal.result(suite.text, suite.json);
    return 0;
  }
  if (arguments.tradeOff) {
    const std::vector<TradeOff> rows = measureTradeOff(arguments.seed, arguments.quick, progress);
    if (!arguments.output.empty()) {
      writeImage(drawTradeOff(rows), arguments.output);
      terminal.say("wrote {}", arguments.output);
    }
    terminal.result(tradeOffTable(rows), jsonOf(rows));
    return 0;
  }
  const std::shared_ptr<const ColorConfig> config = programConfig();
  std::vector<SolverError> errors;
  for (const std::string& capture : arguments.captures) {
    const auto rows = measureSolverError(readCapture(*config, capture), arguments.seed, progress);
    errors.insert(errors.end(), rows.begin(), rows.end());
  }
  std::vector<SolverSpeed> speeds;
  if (!arguments.noSpeed) {
    SolverSpeedOptions options;
    if (arguments.quick) options.width = 960, options.height = 540, options.seconds = 0.02;
    speeds = measureSolverSpeed(options, progress);
  }
  if (!arguments.output.empty() && !errors.empty()) {
    writeImage(paretoPlot(errors), arguments.output);
    terminal.say("wrote {}", arguments.output);
  }
  std::string text = speedTable(speeds);
  if (!errors.empty()) text += "\n" + errorTable(errors);
  terminal.result(text + "\n" + kNotMeasured, jsonOf(speeds, errors));
  return 0;
}

}  // namespace

void addBenchVerb(Program& program) {
  const auto a = std::make_shared<BenchCommand>();
  CLI::App& verb = program.addVerb("bench", "Measure speed against error of every solver",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("CAPTURE", a->captures, "Captures with truth, such as samples/*/capture.json");
  verb.add_option("-o,--output", a->output, "Plot error against cost")->type_name("FILE.png");
  verb.add_option("--seed", a->seed, "Seed of the noise")->type_name("N");
  verb.add_flag("--no-speed", a->noSpeed, "Measure errors only");
  verb.add_flag("--hard-cases", a->hardCases,
                "Instead, run every model on synthetic captures, each hard in one way");
  verb.add_flag(
      "--trade-off", a->tradeOff,
      "Instead, speed against error of every solver: a still life of 2, 3, 4 and 8 lights, matte and glossy");
  verb.add_flag("--quick", a->quick, "Small pictures and one repetition, as a quick check");
}

}  // namespace swaplight
