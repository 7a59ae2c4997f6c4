#include "app/verbs/bench_hard_cases.h"

#include <algorithm>
#include <functional>

#include "core/base/json.h"
#include "core/bench/hard_case_error.h"
#include "core/ocio/chosen_config.h"

namespace swaplight {
namespace {

using Figure = std::function<std::string(const SolutionError&)>;

/// A row a case, a column a model, and one more at the end.
std::string table(const std::vector<HardCaseError>& rows, const std::string& title, const Figure& figure,
                  const std::string& lastTitle,
                  const std::function<std::string(const HardCaseError&)>& last) {
  std::vector<std::vector<std::string>> cells{{title}};
  for (const std::string& model : hardCaseModels()) cells.front().push_back(model);
  cells.front().push_back(lastTitle);
  for (const HardCaseError& row : rows) {
    cells.push_back({row.name});
    for (const std::string& model : hardCaseModels()) {
      const SolutionError* error = row.find(model);
      cells.back().push_back(error ? figure(*error) : "");
    }
    cells.back().push_back(last(row));
  }
  return tableText(cells) + "\n";
}

/// The error of `auto` over the smaller one of lambert and transport.
double autoOverBest(const HardCaseError& row) {
  return row.find("auto")->relativeRmse /
         std::min(row.find("lambert")->relativeRmse, row.find("transport")->relativeRmse);
}

std::string notFiniteText(const HardCaseError& row) {
  size_t notFinite = 0;
  for (const HardCaseError::Answer& answer : row.answers) notFinite += answer.error.notFinite;
  return std::to_string(notFinite);
}

Json jsonOf(const HardCaseError& row) {
  Json json{{"name", row.name},        {"group", row.group},          {"matte", row.matte},
            {"mixed", row.mixed},      {"bound_rel_rmse", row.bound}, {"auto_over_best", autoOverBest(row)},
            {"models", Json::object()}};
  for (const auto& [model, error] : row.answers)
    json["models"][model] = {{"rel_rmse", error.relativeRmse},
                             {"beta_rmse_over_bound", error.betaOverBound},
                             {"de_mean", error.deltaEMean},
                             {"de_p95", error.deltaE95},
                             {"within_two_sigma", error.withinTwoSigma},
                             {"not_finite", error.notFinite}};
  return json;
}

/// Mean dE00 of auto over that of the published method, where it applies.
double meanAgainstPublished(const std::vector<HardCaseError>& rows) {
  double ours = 0;
  double published = 0;
  for (const HardCaseError& row : rows)
    if (const SolutionError* error = row.find("published"))
      ours += row.find("auto")->deltaEMean, published += error->deltaEMean;
  return ours / published;
}

}  // namespace

Description benchHardCases(const std::vector<std::string>& captures, unsigned seed, bool quick,
                           const Progress& progress) {
  const int own = int(hardCaseNames().size());
  const size_t count = size_t(own) + captures.size();
  std::vector<HardCaseError> rows;
  const auto measure = [&](const HardCase& hardCase) {
    progress.update(float(rows.size()) / float(count), hardCase.name);
    rows.push_back(measureHardCase(hardCase));
  };
  for (int i = 0; i < own; ++i) measure(makeHardCase(i, seed, quick ? 48 : 192));
  const std::shared_ptr<const ColorConfig> config = programConfig();
  for (const std::string& capture : captures) measure(hardCaseOfCapture(readCapture(*config, capture), seed));

  Description d;
  d.text += table(
      rows, "relative RMSE of T",
      [](const SolutionError& e) { return fmt::format("{:.4f}", e.relativeRmse); }, "bound   auto/best",
      [](const HardCaseError& row) { return fmt::format("{:.4f}  {:.2f}", row.bound, autoOverBest(row)); });
  d.text += table(
      rows, "mean dE00", [](const SolutionError& e) { return fmt::format("{:.2f}", e.deltaEMean); },
      "not finite", notFiniteText);
  d.text += table(
      rows, "beta error over bound",
      [](const SolutionError& e) {
        return e.betaOverBound > 0 ? fmt::format("{:.2f}", e.betaOverBound) : std::string("-");
      },
      "", [](const HardCaseError&) { return std::string(); });
  d.text += table(
      rows, "within 2 sigma", [](const SolutionError& e) { return fmt::format("{:.3f}", e.withinTwoSigma); },
      "matte", [](const HardCaseError& row) { return std::string(row.matte ? "matte" : ""); });
  const double ratio = meanAgainstPublished(rows);
  d.text += fmt::format("  mean dE00 of auto over that of the published method, where that applies: {:.2f}\n",
                        ratio);
  d.json = {{"cases", Json::array()}, {"de_mean_auto_over_published", ratio}};
  for (const HardCaseError& row : rows) d.json["cases"].push_back(jsonOf(row));
  return d;
}

}  // namespace swaplight
