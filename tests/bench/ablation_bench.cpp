// What the constants that steer the solver and the search for shadows are worth: each halved, half as large
// again, and mechanisms switched off. Prints a JSON object a line; scripts/make_ablation makes tables of
// them.
//
// usage: ablation_bench solve [--width N] [--seed N] [--only PREFIX] [--set NAME=VALUE]...
//        ablation_bench shadows SOLVED.exr TRUTH_FOLDER [--only PREFIX] [--set NAME=VALUE]...
//
// solve: model auto on the hard cases (swaplight bench --hard-cases), N pixels wide. shadows: a solved set
// and the folder with its shadow_<light>.exr (Y: visibility). --only changes the constants whose names begin
// so, --set measures one change alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/base/tuning.h"
#include "core/bench/bench_truth.h"
#include "core/bench/hard_cases.h"
#include "core/bench/solution_error.h"
#include "core/image/io/image_io.h"
#include "core/set/solved_file.h"
#include "core/shadow/detect/detect_shadows.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/solve.h"

using namespace swaplight;  // NOLINT(google-build-using-namespace)

namespace {

struct Change {
  std::string name;  ///< of the constant, or what is switched off
  std::map<std::string, double> values;
};

struct Arguments {
  std::vector<std::string> names;
  std::string only;
  int width = 96;
  unsigned seed = 2;
  std::optional<Change> single;
};

// Values with which a mechanism does nothing.
const std::vector<Change> kSolveSwitches = {
    {"pooling of beta off", {{"auto.pooling.near_chi2", 1e-12}, {"auto.pooling.far_chi2", 1e-12}}},
    {"second pooling off", {{"auto.pooling.far_chi2", 1e-12}}},
    {"beyond the matte model: nothing", {{"auto.shrinkage.gate", 1e9}}},
    {"odds from neighbours off", {{"auto.neighbourhood.temper", 1e9}}},
    {"edge noise off", {{"auto.edges.min_misfit_ratio", 1e9}}},
    {"noise calibration off", {{"noise.largest_factor", 1}, {"noise.nothing_flat", 0}}},
    {"colour uncertainty off", {{"colors.absorbed", 0}, {"colors.noisy_uncertainty", 0}}},
    {"motion off", {{"motion.min_misfit", 1e9}}},
    {"colour of the ambient light off", {{"ambient.min_pixels", 2e9}}},
    {"filling of dark beta off", {{"too_dark_sigma", 1e9}}},
};
const std::vector<Change> kShadowSwitches = {
    {"noise removal off", {{"evidence.denoise_radius", 0}}},
    {"reflectance not removed", {{"evidence.surface_share", 0}}},
    {"sides of edges off", {{"cut.side_cost", 0}}},
    {"borders off", {{"cut.parting_cost", 0}, {"cut.least_parting", 1e-6}}},
    {"exact cast penumbras off", {{"penumbra.least_cast", 2}}},
    {"surfaces that turn away off", {{"penumbra.least_turning", 2}}},
    {"floor of shadows off", {{"floor.fewest", 2e9}}},
    {"light that fades off", {{"fading.gone", -100}}},
    {"unusual levels allowed", {{"threshold.spread_below", 1e6}, {"threshold.spread_above", 1e6}}},
};

/// Sets constants by name; ends the program where there is no such one.
template <typename Tuning>
Tuning changed(const Change& change) {
  Tuning tuning;
  size_t found = 0;
  visitTuning(tuning, [&](const std::string& name, auto& value) {
    const auto wanted = change.values.find(name);
    if (wanted == change.values.end()) return;
    value = static_cast<std::remove_cvref_t<decltype(value)>>(wanted->second);
    ++found;
  });
  if (found == change.values.size()) return tuning;
  fmt::print(stderr, "ablation_bench: \"{}\" names a constant that there is not\n", change.name);
  std::exit(2);
}

/// Each constant halved and half as large again, then the switches.
template <typename Tuning>
std::vector<Change> changesOf(const Arguments& arguments, const std::vector<Change>& switches) {
  if (arguments.single) return {*arguments.single};
  std::vector<Change> changes{{"default", {}}};
  Tuning tuning;
  visitTuning(tuning, [&](const std::string& name, auto& value) {
    if (!name.starts_with(arguments.only)) return;
    for (const double factor : {.5, 1.5}) {
      double other = static_cast<double>(value) * factor;
      if (std::is_integral_v<std::remove_cvref_t<decltype(value)>>) other = std::floor(other);
      // Quantiles and correlations end at 1: what they lack of it is doubled, or halved.
      if (name.ends_with("_level") || name.ends_with("whiteness"))
        other = 1 - (factor < 1 ? 2 : .5) * (1 - value);
      changes.push_back({name, {{name, other}}});
    }
  });
  if (arguments.only.empty()) changes.insert(changes.end(), switches.begin(), switches.end());
  return changes;
}

void print(const Change& change, const Json& figures) {
  fmt::print("{}\n", Json{{"name", change.name}, {"values", change.values}, {"figures", figures}}.dump());
  std::fflush(stdout);
}

/// A hard case, photographed once.
struct SolveCase {
  HardCase test;
  BoundedTruth truth;
  explicit SolveCase(HardCase made)
      : test(std::move(made)),
        truth(benchTruth(test.capture, test.truth), lightingFromCapture(test.capture), test.noise,
              test.pixels.clipLevel.front()) {}
};

void measureSolve(const Arguments& arguments) {
  std::vector<SolveCase> cases;
  for (int i = 0; i < int(hardCaseNames().size()); ++i)
    cases.emplace_back(makeHardCase(i, arguments.seed, arguments.width));
  for (const Change& change : changesOf<SolveTuning>(arguments, kSolveSwitches)) {
    const auto tuning = changed<SolveTuning>(change);
    Json figures = Json::object();
    for (const SolveCase& one : cases) {
      const SolutionError error =
          compareSolution(solve(one.test.capture, one.test.pixels, one.test.options, {}, tuning), one.truth);
      figures[one.test.name] = {{"rel_rmse", error.relativeRmse},
                                {"de_mean", error.deltaEMean},
                                {"within_two_sigma", error.withinTwoSigma}};
    }
    print(change, figures);
  }
}

/// As tests/bench/shadow_table.py has them: umbra is visibility below .02, lit above .98.
Json shadowFigures(const LightShadows& found, const Image& truth) {
  const int channel = truth.channelIndex("Y");
  const float* visible = truth.plane(channel);
  double both = 0, either = 0, umbra = 0, wrong = 0, error = 0, known = 0;
  double allBoth = 0, allEither = 0, allError = 0;  // unknown pixels as what their visibility says
  for (size_t p = 0; p < truth.pixelCount(); ++p) {
    const bool isUmbra = visible[p] < .02F;
    umbra += isUmbra;
    wrong += found.labels[p] == ShadowLabel::Umbra && visible[p] > .98F;
    const bool dark = found.visibility.plane(0)[p] < .1F;
    allBoth += dark && isUmbra;
    allEither += dark || isUmbra;
    allError += std::abs(found.visibility.plane(0)[p] - visible[p]);
    if (found.labels[p] == ShadowLabel::Unknown) continue;
    const bool called = found.labels[p] == ShadowLabel::Umbra;
    both += called && isUmbra;
    either += called || isUmbra;
    error += std::abs(found.visibility.plane(0)[p] - visible[p]);
    known += 1;
  }
  const auto pixels = static_cast<double>(truth.pixelCount());
  return {{"umbra", both / std::max(either, 1.)},
          {"error", error / std::max(known, 1.)},
          {"false", wrong / pixels},
          {"all_umbra", allBoth / std::max(allEither, 1.)},
          {"all_error", allError / pixels},
          {"unknown", 1 - known / pixels},
          {"truth", umbra / pixels}};
}

void measureShadows(const Arguments& arguments) {
  if (arguments.names.size() != 2) {
    fmt::print(stderr, "ablation_bench: shadows takes a solved set and the folder of its truth\n");
    std::exit(2);
  }
  const SolvedSet set = readSolvedSet(arguments.names[0]);
  std::vector<Image> truths;
  for (const Light& light : set.capture.lights) {
    const auto file = std::filesystem::path(arguments.names[1]) / ("shadow_" + light.name + ".exr");
    truths.push_back(std::filesystem::exists(file) ? readImage(file).image : Image());
  }
  for (const Change& change : changesOf<ShadowTuning>(arguments, kShadowSwitches)) {
    const std::vector<LightShadows> found = detectShadows(set, {}, {}, changed<ShadowTuning>(change));
    Json figures = Json::object();
    for (size_t i = 0; i < found.size(); ++i)
      if (!truths[i].empty()) figures[set.capture.lights[i].name] = shadowFigures(found[i], truths[i]);
    print(change, figures);
  }
}

Change changeFromText(const std::string& text) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos) {
    fmt::print(stderr, "ablation_bench: --set takes NAME=VALUE, not \"{}\"\n", text);
    std::exit(2);
  }
  return {text, {{text.substr(0, equals), std::atof(text.c_str() + equals + 1)}}};
}

}  // namespace

int main(int argc, char** argv) try {
  Arguments arguments;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (size_t i = 1; i < words.size(); ++i) {
    const bool takesValue = words[i].starts_with("--") && i + 1 < words.size();
    if (!takesValue) arguments.names.push_back(words[i]);
    if (!takesValue) continue;
    const std::string& value = words[i + 1];
    if (words[i] == "--width") arguments.width = std::atoi(value.c_str());
    if (words[i] == "--seed") arguments.seed = unsigned(std::atoi(value.c_str()));
    if (words[i] == "--only") arguments.only = value;
    if (words[i] == "--set") {
      const Change change = changeFromText(value);
      if (!arguments.single) arguments.single.emplace();
      arguments.single->name += (arguments.single->name.empty() ? "" : ", ") + change.name;
      arguments.single->values.insert(change.values.begin(), change.values.end());
    }
    ++i;
  }
  if (!words.empty() && words[0] == "solve")
    measureSolve(arguments);
  else if (!words.empty() && words[0] == "shadows")
    measureShadows(arguments);
  else
    fmt::print(stderr, "usage: ablation_bench solve|shadows ... (see its source)\n");
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "ablation_bench: {}\n", error.what());
  return 2;
}
