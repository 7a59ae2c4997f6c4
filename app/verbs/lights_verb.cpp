#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "app/arguments/solve_arguments.h"
#include "app/program/description.h"
#include "app/program/number_range.h"
#include "app/verbs/verbs.h"
#include "core/balance/lamp_reading.h"
#include "core/balance/photograph.h"
#include "core/balance/reading_rig.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/file/same_file.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"

namespace swaplight {
namespace {

struct LightsCommand {
  std::string source;
  std::string photograph;
  std::string rig;
  std::string colorSpace;
  std::string noise;
  std::optional<float> ambient;
  LampReadingOptions options;
};

std::string number(double value, int digits = 4) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "?";
}

/// A lamp's row, out of its JSON.
std::vector<std::string> rowOf(const std::string& name, const Json& lamp) {
  const auto three = [&](const char* key) {
    std::string text;
    for (const Json& value : lamp[key])
      text += (text.empty() ? "" : "/") + (value.is_null() ? "?" : number(value.get<double>()));
    return text;
  };
  const bool on = lamp["on"].get<bool>();
  std::string level = lamp["known"].get<bool>() ? "off" : "?";
  if (on) {
    const double luminance = lamp["luminance"].get<double>();
    level = fmt::format("{:+.2f} st ± {:.2f}", lamp["stops"].get<double>(),
                        lamp["luminance_error"].get<double>() / luminance / std::log(2.0));
  }
  const std::string white =
      lamp.contains("kelvin")
          ? fmt::format("{:.0f} K, Duv {:+.3f}", lamp["kelvin"].get<double>(), lamp["duv"].get<double>())
          : "";
  return {name, three("color"), three("standard_error"), level, white};
}

std::string textOf(const LampReading& reading, const Json& json) {
  std::vector<std::vector<std::string>> rows{{"lamp", "colour", "standard error", "level", "white"}};
  for (const auto& [name, lamp] : json["lights"].items()) rows.push_back(rowOf(name, lamp));
  std::string text = tableText(std::move(rows));
  if (reading.ambient)
    text += fmt::format("  ambient light x{:.3f} ± {:.3f}\n", *reading.ambient, reading.ambientError);
  text += fmt::format(
      "  Differs from the set by {:.1f} % where it is bright; noise alone would leave {:.1f} %. Left out: "
      "{:.1f} %.\n",
      100 * reading.misfit, 100 * reading.expectedMisfit, 100 * (1 - reading.used * (1 - reading.leftOut)));
  return text;
}

/// The names of the lamps that the photograph does not tell.
std::string unknownIn(const Json& lamps) {
  std::vector<std::string> names;
  for (const auto& [name, lamp] : lamps.items())
    if (!lamp["known"].get<bool>()) names.push_back(name);
  return fmt::format("{}", fmt::join(names, ", "));
}

int run(const LightsCommand& arguments, Terminal& terminal) {
  std::vector<std::filesystem::path> inputs = filesOfSource(arguments.source);
  inputs.emplace_back(arguments.photograph);
  if (!arguments.rig.empty()) checkOutput(arguments.rig, inputs);
  checkEnding(arguments.rig, std::array{".json"}, "a rig");
  LampReadingOptions options = arguments.options;
  options.ambient = arguments.ambient;
  if (!arguments.noise.empty()) options.noise = noiseFromText(arguments.noise);

  const Progress progress = terminal.progress();
  const std::shared_ptr<const ColorConfig> config = programConfig();
  SolveOptions solving;
  solving.highlights = false;  // nothing here looks at them
  const SolvedSet set = openSource(*config, arguments.source, solving, progress.part(0, 0.5F));
  if (options.ambient && !set.ambient)
    throw InputError("--ambient: {} has no ambient light: leave it out", arguments.source);
  const CapturePixels photograph =
      loadPhotographOf(*config, set, arguments.photograph, arguments.colorSpace, progress.part(0.5F, 0.7F));
  sayWarnings(photograph.warnings, terminal);
  LampReading reading;
  try {
    reading = readLamps(set, photograph, options, progress.part(0.7F, 1));
  } catch (const InputError& error) {
    throw InputError("{}: {}", arguments.photograph, error.what());
  }
  for (std::string& warning : reading.warnings) warning = arguments.photograph + ": " + warning;
  sayWarnings(reading.warnings, terminal);

  Json json{{"source", arguments.source}, {"photograph", arguments.photograph}};
  json.update(jsonFromReading(*config, set, reading));
  if (!arguments.rig.empty()) {
    if (const std::string unknown = unknownIn(json["lights"]); !unknown.empty())
      terminal.say("warning: the rig leaves {} on and white", unknown);
    writeJson(json["rig"], arguments.rig);
    terminal.say("wrote {}", arguments.rig);
  }
  terminal.result(textOf(reading, json), json);
  return 0;
}

}  // namespace

void addLightsVerb(Program& program) {
  const auto a = std::make_shared<LightsCommand>();
  CLI::App& verb = program.addVerb("lights", "Read every lamp's colour and level from one photograph",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SOLVED", a->source, "The solved set, or a capture to solve")->required();
  verb.add_option("PHOTO", a->photograph, "Another photograph of it, by the same camera at the same place")
      ->required();
  verb.add_option("--rig", a->rig, "Write the lamps as a rig, which relight --rig takes")
      ->type_name("FILE.json");
  verb.add_option("--color-space", a->colorSpace,
                  "Of the photograph (default: as the capture's files, or what the file says)")
      ->type_name("NAME");
  verb.add_option("--exposure", a->options.exposureStops,
                  "The photograph's exposure over that of the capture's first shot")
      ->check(NumberRange(-30, 30))
      ->type_name("STOPS");
  verb.add_option("--ambient", a->ambient, "The ambient light's level over the set's (default: read, too)")
      ->check(NumberRange(0, 1e6))
      ->type_name("X");
  verb.add_option("--noise", a->noise,
                  "Of the photograph, as read=.002,full_well=20000 (default: the capture's, else estimated)")
      ->type_name("NOISE");
  verb.add_flag("--align", a->options.align, "Move the photograph onto the set, where it lies beside it");
}

}  // namespace swaplight
