#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "app/arguments/place_text.h"
#include "app/arguments/solve_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/no_such_light.h"
#include "core/edit/stack/edit_file.h"
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
  std::vector<std::string> shadowLabels, litLabels;
  std::string edits;
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

/// A mark, and the light that it names; empty: the only one.
struct LabelledPlace {
  std::string light;
  ShadowMark mark;
};

/// X,Y or LIGHT=X,Y.
LabelledPlace labelFromText(const std::string& text, ShadowMark::Kind is) {
  const size_t sign = text.rfind('=');
  const std::string light = sign == std::string::npos ? "" : text.substr(0, sign);
  const std::string option = fmt::format("--label-{} {}", wordFor(is), text);
  const auto [x, y] = placeFromText(sign == std::string::npos ? text : text.substr(sign + 1), option);
  return {light, {is, x, y}};
}

std::vector<LabelledPlace> labelledPlaces(const ShadowsCommand& arguments) {
  std::vector<LabelledPlace> places;
  for (const std::string& text : arguments.shadowLabels)
    places.push_back(labelFromText(text, ShadowMark::Kind::Shadow));
  for (const std::string& text : arguments.litLabels)
    places.push_back(labelFromText(text, ShadowMark::Kind::Lit));
  for (const LabelledPlace& a : places)
    for (const LabelledPlace& b : places)
      if (a.light == b.light && a.mark.x == b.mark.x && a.mark.y == b.mark.y && a.mark.is != b.mark.is)
        throw InputError("{},{} is labelled shadow and lit: say one of them", a.mark.x, a.mark.y);
  return places;
}

void applyLabels(const std::vector<LabelledPlace>& places, const std::vector<std::string>& lights,
                 ShadowOptions& options) {
  for (const LabelledPlace& place : places) {
    if (place.light.empty() && lights.size() != 1)
      throw InputError("--label-{0} {1},{2}: say of which light: LIGHT={1},{2}; the lights are {3}",
                       wordFor(place.mark.is), place.mark.x, place.mark.y, fmt::join(lights, ", "));
    options.marks[place.light.empty() ? lights.front() : place.light].push_back(place.mark);
  }
}

std::vector<std::string> chosenLights(const ShadowsCommand& arguments, const Capture& capture) {
  std::vector<std::string> known;
  for (const Light& light : capture.lights) known.push_back(light.name);
  std::vector<std::string> chosen;
  for (const std::string& name : arguments.lights) {
    static_cast<void>(placeOfLight(known, name, arguments.source));
    if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
  }
  return chosen.empty() ? known : chosen;
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

/// The thresholds and labels that a file of edits holds.
ShadowOptions optionsOfEdits(const ShadowsCommand& arguments, const SolvedSet& set, Terminal& terminal) {
  if (arguments.edits.empty()) return {};
  std::vector<std::string> warnings;
  const EditStack edits = readEdits(arguments.edits, set.width(), set.height(), &warnings);
  sayWarnings(warnings, terminal);
  return shadowOptionsOf(edits);
}

int run(const ShadowsCommand& arguments, Terminal& terminal) {
  ShadowOptions given;
  for (const std::string& text : arguments.thresholds) applyThreshold(text, given);
  const std::vector<LabelledPlace> places = labelledPlaces(arguments);
  SolveOptions solving = arguments.solve.resolveFor(arguments.source);
  solving.highlights = false;  // nothing here looks at them
  std::filesystem::path overlay = arguments.overlay;
  if (overlay.empty()) overlay = std::filesystem::path(arguments.output).replace_extension(".png");
  std::vector<std::filesystem::path> inputs = filesOfSource(arguments.source);
  inputs.emplace_back(arguments.edits);
  checkShadowFile(arguments.output);
  static_cast<void>(imageFormatForWriting(overlay));
  checkOutputs(std::array<std::filesystem::path, 2>{arguments.output, overlay}, inputs);

  const Progress progress = terminal.progress();
  const SolvedSet set = openSource(*programConfig(), arguments.source, solving, progress.part(0, .4f));
  sayWarnings(set.capture.warnings, terminal);
  const std::vector<std::string> names = chosenLights(arguments, set.capture);
  ShadowOptions options = optionsOfEdits(arguments, set, terminal);
  options.threshold = given.threshold;
  for (const auto& [light, threshold] : given.thresholds) {
    if (std::find(names.begin(), names.end(), light) == names.end())
      throw InputError("--threshold {}=…: {} is none of the lights asked for ({})", light, light,
                       fmt::join(names, ", "));
    options.thresholds[light] = threshold;
  }
  applyLabels(places, names, options);
  const std::vector<LightShadows> all = detectShadows(set, options, progress.part(.4f, .95f));

  std::vector<NamedShadows> lights;
  std::string text;
  Json json = {{"shadows", arguments.output}, {"overlay", overlay.string()}, {"lights", Json::object()}};
  for (const std::string& name : names) {
    lights.push_back({name, &all[static_cast<size_t>(set.capture.lightIndex(name))]});
    text += textOf(lights.back());
    json["lights"][name] = jsonFromShadows(*lights.back().shadows);
  }
  writeShadows(set, lights, arguments.output);
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
  verb.add_option("--label-shadow", a->shadowLabels,
                  "A pixel that the light does not reach, and so the surface around it; may be given again")
      ->type_name("[LIGHT=]X,Y");
  verb.add_option("--label-lit", a->litLabels, "The same of a pixel that the light reaches")
      ->type_name("[LIGHT=]X,Y");
  verb.add_option("--edits", a->edits, "Take thresholds and labels from a JSON file of edits")
      ->type_name("FILE");
  verb.add_option("-o,--output", a->output, "Visibility and labels, one layer per light")
      ->required()
      ->type_name("SHADOWS.exr");
  verb.add_option("--overlay", a->overlay,
                  "The outlines over the picture (default: the output's name with .png)")
      ->type_name("FILE.png");
  a->solve.addWithoutHighlightsTo(verb);
}

}  // namespace swaplight
