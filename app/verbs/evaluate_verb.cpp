#include <array>
#include "app/program/number_range.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/same_file.h"
#include "core/measure/evaluate.h"
#include "core/measure/folder_evaluation.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

struct EvaluateCommand {
  std::string test;
  std::string reference;
  std::string metrics;
  std::string channels;
  std::vector<std::string> regions;
  std::vector<double> weights;
  std::optional<float> scale;
  EvaluateOptions options;
};

void sayWritten(const EvaluateOptions& options, Terminal& terminal) {
  for (const fs::path& file : {options.plot, options.map, options.histogram})
    if (!file.empty()) terminal.say("wrote {}", file.string());
}

int run(const EvaluateCommand& arguments, Terminal& terminal) {
  EvaluateOptions options = arguments.options;
  if (!arguments.metrics.empty()) options.metrics = metricsFromNames(arguments.metrics);
  options.scale = arguments.scale;
  std::stringstream channels(arguments.channels);
  for (std::string name; std::getline(channels, name, ',');) options.channels.push_back(name);
  for (const std::string& text : arguments.regions) {
    const EvaluatedRegion region = regionFromText(text);
    for (const EvaluatedRegion& other : options.regions)
      if (other.name == region.name)
        throw InputError("--region {}: there are two of that name. Give each its own.", region.name);
    options.regions.push_back(region);
  }
  if (!arguments.weights.empty())
    options.difference.weights = {arguments.weights[0], arguments.weights[1], arguments.weights[2]};
  std::error_code ignored;  // the reader says it better
  const bool folders = fs::is_directory(arguments.test, ignored);
  if (folders != fs::is_directory(arguments.reference, ignored))
    throw InputError("{} is {}, {} is {}: name two pictures or two folders", arguments.test,
                     folders ? "a folder" : "none", arguments.reference, folders ? "none" : "a folder");
  const std::array<fs::path, 2> inputs = {arguments.test, arguments.reference};
  checkOutputs(std::array<fs::path, 3>{options.plot, options.map, options.histogram}, inputs);
  if (folders) {
    const FolderEvaluation all =
        evaluateFolders(arguments.test, arguments.reference, options, terminal.progress());
    for (const FolderEvaluation::Picture& picture : all.pictures)
      sayWarnings(picture.evaluation.warnings, terminal);
    sayWritten(options, terminal);
    terminal.result(textFromFolders(all), jsonFromFolders(all));
    return 0;
  }
  const Evaluation evaluation = evaluate(arguments.test, arguments.reference, options);
  sayWarnings(evaluation.warnings, terminal);
  sayWritten(options, terminal);
  terminal.result(textFromEvaluation(evaluation), jsonFromEvaluation(evaluation));
  return 0;
}

}  // namespace

void addEvaluateVerb(Program& program) {
  const auto a = std::make_shared<EvaluateCommand>();
  CLI::App& verb = program.addVerb("evaluate", "Measure how a picture differs from its reference",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("TEST", a->test, "The picture or folder of pictures to evaluate")->required();
  verb.add_option("REFERENCE", a->reference,
                  "The reference: a picture, or a folder with pictures of the same names")
      ->required();
  verb.add_option("--metric", a->metrics, "de2000,absdiff,rmse,psnr (default: all)")->type_name("LIST");
  verb.add_option("--weights", a->weights,
                  "Weights of lightness, chroma and hue in de2000 (default: 1,1,1; 5,1,1: lightness a fifth)")
      ->delimiter(',')
      ->expected(3)
      ->check(NumberRange(1e-3, 1e3))
      ->type_name("L,C,H");
  verb.add_option("--threshold", a->options.difference.threshold,
                  "Give the share of pixels that differ by more than X, for every metric but psnr")
      ->check(NumberRange(0, 1e30))
      ->type_name("X");
  verb.add_option("--channels", a->channels,
                  "Compare these channels as numbers, each by its name in both: beta.key, or beta.* for all "
                  "(default: R, G, B; where a file has none, all channels of both)")
      ->type_name("LIST");
  verb.add_option("--region", a->regions, "Measure this rectangle by itself, too; may be given again")
      ->type_name("[NAME=]X,Y,W,H");
  verb.add_option(
          "--scale", a->scale,
          "Show linear pictures at this exposure (default: the reference's 99.5th percentile becomes .9)")
      ->check(NumberRange(1e-30, 1e30))
      ->type_name("X");
  verb.add_option("--plot", a->options.plot,
                  "Write a box plot; for folders one box per picture, of the first metric")
      ->type_name("FILE.png");
  verb.add_option("--histogram", a->options.histogram, "Plot the luminance of both")->type_name("FILE.png");
  verb.add_option("--map", a->options.map, "Write the first metric in false colour")->type_name("FILE.png");
  verb.add_option("--map-max", a->options.mapMaximum,
                  "Value at the top of the false colours (default: the 99th percentile)")
      ->check(NumberRange(0, 1e30))
      ->type_name("X");
}

}  // namespace swaplight
