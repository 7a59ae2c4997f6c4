#include <fmt/format.h>

#include "app/arguments/edit_arguments.h"
#include "app/arguments/solve_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/json.h"
#include "core/edit/stack/beta_file.h"
#include "core/file/atomic_file.h"
#include "core/file/same_file.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"

namespace swaplight {
namespace {

struct BetaCommand {
  std::string source;
  std::string output;
  EditArguments edits;
  SolveArguments solve;
};

int run(const BetaCommand& arguments, Terminal& terminal) {
  const SolveOptions options = arguments.solve.resolveFor(arguments.source);
  std::vector<std::filesystem::path> inputs = filesOfSource(arguments.source);
  const std::vector<std::filesystem::path> edits = arguments.edits.inputs();
  inputs.insert(inputs.end(), edits.begin(), edits.end());
  checkWritable(arguments.output);
  checkOutputs(betaMapFiles(arguments.output, {}), inputs);  // an EXR before the work; lights name the PNGs
  const SolvedSet set =
      arguments.edits.applyTo(openSource(*programConfig(), arguments.source, options, terminal.progress()));
  sayWarnings(set.capture.warnings, terminal);
  std::vector<std::string> lights;
  for (const Light& light : set.capture.lights) lights.push_back(light.name);
  checkOutputs(betaMapFiles(arguments.output, lights), inputs);
  Json files = Json::array();
  for (const auto& file : writeBetaMaps(set, arguments.output)) {
    terminal.say("wrote {}", file.string());
    files.push_back(file.string());
  }
  terminal.result("", {{"files", std::move(files)}, {"width", set.width()}, {"height", set.height()}});
  return 0;
}

}  // namespace

void addBetaVerb(Program& program) {
  const auto a = std::make_shared<BetaCommand>();
  CLI::App& verb = program.addVerb("beta", "Write the lights' beta maps for an image editor",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SOURCE", a->source, "A solved set, or a capture to solve")->required();
  verb.add_option("-o,--output", a->output,
                  "An EXR with a channel beta.LIGHT each, or NAME.png for a 16-bit NAME.LIGHT.png each")
      ->required()
      ->type_name("MAPS");
  a->edits.addTo(verb);
  a->solve.addTo(verb);
}

}  // namespace swaplight
