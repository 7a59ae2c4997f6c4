#include "core/measure/folder_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/image/io/image_io.h"
#include "core/plot/plot.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

using Files = std::map<std::string, fs::path>;

/// Pictures below a folder, by their path in it without extension.
Files picturesBelow(const fs::path& folder) {
  static const std::set<std::string> extensions = {".exr", ".png", ".tif", ".tiff", ".jpg", ".jpeg", ".hdr"};
  Files files;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied)) {
    if (!entry.is_regular_file() || extensions.count(lowerExtension(entry.path())) == 0) continue;
    const fs::path name = fs::relative(entry.path(), folder).replace_extension();
    const auto [known, isNew] = files.emplace(name.generic_string(), entry.path());
    if (!isNew)
      throw InputError(
          "{}: {} has the same name but for the extension: which of both is to be compared? Keep "
          "one of them in the folder.",
          entry.path().string(), known->second.filename().string());
  }
  return files;
}

struct Column {
  const char* name;
  double (*value)(const Difference&);
};

constexpr std::array<Column, 11> kColumns = {
    {{"value", [](const Difference& d) { return d.value; }},
     {"mean", [](const Difference& d) { return d.statistics.mean; }},
     {"median", [](const Difference& d) { return d.statistics.median; }},
     {"p95", [](const Difference& d) { return d.statistics.p95; }},
     {"p99", [](const Difference& d) { return d.statistics.p99; }},
     {"max", [](const Difference& d) { return d.statistics.max; }},
     {"std", [](const Difference& d) { return d.statistics.std; }},
     {"q1", [](const Difference& d) { return d.statistics.q1; }},
     {"q3", [](const Difference& d) { return d.statistics.q3; }},
     {"outliers", [](const Difference& d) { return static_cast<double>(d.statistics.outliers); }},
     {"share_above", [](const Difference& d) { return *d.shareAbove; }}}};

/// Those of a metric: without a threshold nothing is above it.
std::span<const Column> columnsOf(const Difference& d) {
  return std::span(kColumns).first(kColumns.size() - (d.shareAbove ? 0 : 1));
}

double meanOf(const FolderEvaluation& evaluation, size_t metric, const Column& column) {
  double sum = 0;
  for (const auto& picture : evaluation.pictures)
    sum += column.value(picture.evaluation.differences.at(metric));
  return sum / static_cast<double>(evaluation.pictures.size());
}

Image plotOf(const FolderEvaluation& evaluation) {
  constexpr int kColumn = 190, kAxis = 90, kLeast = 900, kMost = 6000;
  BoxPlot plot;
  const Metric metric = evaluation.pictures.front().evaluation.differences.front().metric;
  const auto nameOf = [](const fs::path& folder) {  // of "relit/", too
    return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  };
  plot.title = nameOf(evaluation.test) + " against " + nameOf(evaluation.reference);
  plot.value = {metricLabel(metric), false, {}, {}};
  for (const auto& picture : evaluation.pictures)
    plot.boxes.push_back({picture.name, picture.evaluation.differences.front().statistics});
  const int width = kAxis + kColumn * static_cast<int>(plot.boxes.size());
  return drawBoxPlot(plot, {std::clamp(width, kLeast, kMost), 600});
}

void add(LuminanceHistogram& sum, const LuminanceHistogram& one, double weight) {
  sum.share.resize(one.share.size(), 0);
  for (size_t i = 0; i < one.share.size(); ++i) sum.share[i] += weight * one.share[i];
  sum.black += weight * one.black;
  sum.bright += weight * one.bright;
  sum.median += weight * one.median;
}

Image histogramOf(const FolderEvaluation& evaluation) {
  NamedHistogram test{"test", {}}, reference{"reference", {}};
  const double weight = 1 / static_cast<double>(evaluation.pictures.size());
  for (const auto& picture : evaluation.pictures) {
    add(test.histogram, *picture.evaluation.testLuminance, weight);
    add(reference.histogram, *picture.evaluation.referenceLuminance, weight);
  }
  return drawLuminanceHistograms({test, reference});
}

}  // namespace

FolderEvaluation evaluateFolders(const fs::path& test, const fs::path& reference,
                                 const EvaluateOptions& options, const Progress& progress) {
  if (!options.map.empty())
    throw InputError("{}: a map is of one pair of pictures; name two pictures, or leave it out",
                     options.map.string());
  const Files tests = picturesBelow(test);
  const Files references = picturesBelow(reference);
  FolderEvaluation result{test.string(), reference.string(), {}, {}};
  EvaluateOptions each = options;
  each.plot.clear();
  each.histogram.clear();
  each.luminance = options.luminance || !options.histogram.empty();
  size_t done = 0;
  for (const auto& [name, file] : tests) {
    progress.update(static_cast<float>(done++) / static_cast<float>(tests.size()), "comparing");
    const auto partner = references.find(name);
    if (partner == references.end()) {
      result.unmatched.push_back(file.string());
      continue;
    }
    Evaluation evaluation = evaluate(file, partner->second, each);
    if (!options.histogram.empty() && !evaluation.testLuminance)
      throw InputError("{}: is compared as numbers, which have no luminance; leave the histogram out",
                       file.string());
    if (!result.pictures.empty() &&
        evaluation.channels.empty() != result.pictures[0].evaluation.channels.empty())
      throw InputError(
          "{} and {}: one is compared as colours, the other as numbers. Compare them apart, or give "
          "--channels",
          result.pictures[0].evaluation.test, file.string());
    for (Difference& d : evaluation.differences) d.map = Image();
    result.pictures.push_back({name, std::move(evaluation)});
  }
  for (const auto& [name, file] : references)
    if (tests.find(name) == tests.end()) result.unmatched.push_back(file.string());
  if (result.pictures.empty())
    throw InputError("{} and {} have no picture of the same name (an extension may differ)", test.string(),
                     reference.string());
  if (!options.plot.empty()) writeImage(plotOf(result), options.plot);
  if (!options.histogram.empty()) writeImage(histogramOf(result), options.histogram);
  return result;
}

Json jsonFromFolders(const FolderEvaluation& evaluation) {
  Json json = {{"test", evaluation.test},
               {"reference", evaluation.reference},
               {"pictures", Json::array()},
               {"unmatched", evaluation.unmatched}};
  for (const auto& picture : evaluation.pictures) {
    Json one = jsonFromEvaluation(picture.evaluation);
    one["name"] = picture.name;
    json["pictures"].push_back(std::move(one));
  }
  const auto& differences = evaluation.pictures.front().evaluation.differences;
  for (size_t m = 0; m < differences.size(); ++m)
    for (const Column& column : columnsOf(differences[m]))
      json["mean"][metricName(differences[m].metric)][column.name] = meanOf(evaluation, m, column);
  return json;
}

std::string textFromFolders(const FolderEvaluation& evaluation) {
  std::string text = fmt::format("{} against {}: {} pictures\n", evaluation.test, evaluation.reference,
                                 evaluation.pictures.size());
  for (const std::string& file : evaluation.unmatched) text += fmt::format("only in one folder: {}\n", file);
  const size_t indent = 2;
  size_t longest = 8;
  for (const auto& picture : evaluation.pictures) {
    longest = std::max(longest, picture.name.size());
    for (const Evaluation::Part& part : picture.evaluation.parts)
      longest = std::max(longest, indent + part.name.size());
  }
  const auto& differences = evaluation.pictures.front().evaluation.differences;
  for (size_t m = 0; m < differences.size(); ++m) {
    const std::span<const Column> columns = columnsOf(differences[m]);
    const auto row = [&](const std::string& name, const Difference& d) {
      text += fmt::format("\n{:{}}", name, longest);
      for (const Column& column : columns) text += fmt::format("{:>12.4g}", column.value(d));
    };
    text += fmt::format("\n{:{}}", metricName(differences[m].metric), longest);
    for (const Column& column : columns) text += fmt::format("{:>12}", column.name);
    for (const auto& picture : evaluation.pictures) {
      row(picture.name, picture.evaluation.differences.at(m));
      for (const Evaluation::Part& part : picture.evaluation.parts)
        row(std::string(indent, ' ') + part.name, part.differences.at(m));
    }
    text += fmt::format("\n{:{}}", "mean", longest);
    for (const Column& column : columns) text += fmt::format("{:>12.4g}", meanOf(evaluation, m, column));
    text += "\n";
  }
  return text;
}

}  // namespace swaplight
