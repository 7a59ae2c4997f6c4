#include <fmt/format.h>

#include <cstdlib>

#include "app/arguments/solve_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/same_file.h"
#include "core/image/io/image_format.h"
#include "core/image/io/image_io.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"
#include "core/shadow/detect/detect_shadows.h"
#include "core/shadow/result/shadow_file.h"

namespace swaplight {
namespace {

struct ShadowsCommand {
  std::string source;
  std::vector<std::string> lights;
  std::vector<std::string> thresholds;
  std::string output;
  std::string overlay;
  SolveArguments solve;
};

float thresholdFromText(const std::string& text) {
  char* end = nullptr;
  const float value = std::strtof(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(value > 0 && value < 1))
    throw InputError("--threshold {}: give auto, or the shading over that of lit pixels, between 0 and 1",
                     text);
  return value;
}

/// auto, X, or LIGHT=X.
void applyThreshold(const std::string& text, ShadowOptions& options) {
  const size_t sign = text.find('=');
  if (sign != std::string::npos)
    options.thresholds[text.substr(0, sign)] = thresholdFromText(text.substr(sign + 1));
  else
    options.threshold = text == "auto" ? std::nullopt : std::optional(thresholdFromText(text));
}

std::vector<std::string> chosenLights(const ShadowsCommand& arguments, const Capture& capture) {
  std::vector<std::string> known;
  for (const Light& light : capture.lights) known.push_back(light.name);
  for (const std::string& name : arguments.lights)
    if (capture.lightIndex(name) < 0)
      throw InputError("{}: has no light \"{}\"; its lights are {}", arguments.source, name,
                       fmt::join(known, ", "));
  return arguments.lights.empty() ? known : arguments.lights;
}

std::string textOf(const NamedShadows& light) {
  const Json json = jsonFromShadows(*light.shadows);
  const auto percent = [&](const char* key) { return 100 * json[key].get<double>(); };
  return fmt::format(
      "{}: umbra {:.1f} %, penumbra {:.1f} % ({:.1f} pixels wide), lit {:.1f} %, unknown {:.1f} %, threshold "
      "{:.3g}\n",
      light.light, percent("umbra"), percent("penumbra"), json["penumbra_pixels"].get<double>(),
      percent("lit"), percent("unknown"), json["threshold"].get<double>());
}

int run(const ShadowsCommand& arguments, Terminal& terminal) {
  ShadowOptions options;
  for (const std::string& text : arguments.thresholds) applyThreshold(text, options);
  const SolveOptions solving = arguments.solve.resolve();
  std::filesystem::path overlay = arguments.overlay;
  if (overlay.empty()) overlay = std::filesystem::path(arguments.output).replace_extension(".png");
  const std::vector<std::filesystem::path> inputs = filesOfSource(arguments.source);
  checkShadowFile(arguments.output);
  static_cast<void>(imageFormatForWriting(overlay));
  checkOutput(arguments.output, inputs);
  checkOutput(overlay, inputs);

  const Progress progress = terminal.progress();
  const SolvedSet set = openSource(*programConfig(), arguments.source, solving, progress.part(0, .4f));
  const std::vector<std::string> names = chosenLights(arguments, set.capture);
  const std::vector<LightShadows> all = detectShadows(set, options, progress.part(.4f, .95f));

  std::vector<NamedShadows> lights;
  std::string text;
  Json json = {{"shadows", arguments.output}, {"overlay", overlay.string()}, {"lights", Json::object()}};
  for (const std::string& name : names) {
    lights.push_back({name, &all[static_cast<size_t>(set.capture.lightIndex(name))]});
    text += textOf(lights.back());
    json["lights"][name] = jsonFromShadows(*lights.back().shadows);
  }
  writeShadows(lights, arguments.output);
  writeImage(drawShadowOutlines(set, lights), overlay);
  terminal.say("wrote {} and {}", arguments.output, overlay.string());
  terminal.result(text, json);
  return 0;
}

}  // namespace

void addShadowsVerb(Program& program) {
  const auto a = std::make_shared<ShadowsCommand>();
  CLI::App& verb = program.addVerb("shadows", "Find each light's shadows",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SOLVED", a->source, "A solved set, or a capture to solve")->required();
  verb.add_option("--light", a->lights, "This light only; may be repeated")->type_name("NAME");
  verb.add_option("--threshold", a->thresholds,
                  "Where shadow begins: auto, or the shading over that of lit pixels, 0..1 (default: auto); "
                  "LIGHT=X for one light (may be given again)")
      ->type_name("auto|X|LIGHT=X");
  verb.add_option("-o,--output", a->output, "Visibility and labels, one layer per light")
      ->required()
      ->type_name("SHADOWS.exr");
  verb.add_option("--overlay", a->overlay,
                  "The outlines over the picture (default: the output's name with .png)")
      ->type_name("FILE.png");
  a->solve.addTo(verb);
}

}  // namespace swaplight
