#include "app/verbs.h"
#include "core/error.h"
#include "core/measure/evaluate.h"

namespace swaplight {
namespace {

struct Arguments {
  std::string test;
  std::string reference;
  std::string metrics;
  std::optional<float> scale;
  EvaluateOptions options;
};

int run(const Arguments& arguments, Terminal& terminal) {
  EvaluateOptions options = arguments.options;
  if (!arguments.metrics.empty()) options.metrics = metricsFromNames(arguments.metrics);
  options.scale = arguments.scale;
  const Evaluation evaluation = evaluate(arguments.test, arguments.reference, options);
  if (!options.plot.empty()) terminal.say("wrote {}", options.plot.string());
  if (!options.map.empty()) terminal.say("wrote {}", options.map.string());
  terminal.result(textFromEvaluation(evaluation), jsonFromEvaluation(evaluation));
  return 0;
}

}  // namespace

void addEvaluateVerb(Program& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App& verb = program.addVerb("evaluate", "Say how a picture differs from its reference",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("TEST", a->test, "The picture to be judged")->required();
  verb.add_option("REFERENCE", a->reference, "What it should be")->required();
  verb.add_option("--metric", a->metrics, "de2000,absdiff,rmse,psnr (default: all)")->type_name("LIST");
  verb.add_option(
          "--scale", a->scale,
          "Show linear pictures at this exposure (default: the reference's 99.5th percentile becomes .9)")
      ->type_name("X");
  verb.add_option("--plot", a->options.plot, "Write a box plot")->type_name("FILE.png");
  verb.add_option("--map", a->options.map, "Write the first metric in false colour")->type_name("FILE.png");
  verb.add_option("--map-max", a->options.mapMaximum,
                  "Value at the top of the false colours (default: the 99th percentile)")
      ->type_name("X");
}

}  // namespace swaplight
