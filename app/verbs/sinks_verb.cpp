#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/arguments/edit_arguments.h"
#include "app/arguments/solve_arguments.h"
#include "app/program/description.h"
#include "app/verbs/verbs.h"
#include "core/base/json.h"
#include "core/illumination/illumination.h"
#include "core/illumination/light_sinks.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"

namespace swaplight {
namespace {

struct SinksCommand {
  std::string source;
  EditArguments edits;
  SolveArguments solve;
};

/// Clockwise from straight up.
double degreesOf(const LightSink::Direction& direction) {
  const double degrees = std::atan2(direction.x, -direction.y) * 180 / std::numbers::pi;
  return degrees < 0 ? degrees + 360 : degrees;
}

Json jsonFromSink(const LightSink& sink) {
  Json json{{"x", sink.x},         {"y", sink.y},           {"radius", sink.radius},
            {"stops", sink.stops}, {"sigmas", sink.sigmas}, {"prominence", sink.prominence}};
  if (sink.outside)
    json["outside"] = {{"x", sink.outside->x}, {"y", sink.outside->y}, {"degrees", degreesOf(*sink.outside)}};
  return json;
}

std::string outsideText(const LightSink& sink) {
  return sink.outside ? fmt::format("goes on outside, {:.0f} degrees", degreesOf(*sink.outside)) : "";
}

void addRows(std::vector<std::vector<std::string>>& rows, const std::string& light,
             const std::vector<LightSink>& sinks) {
  if (sinks.empty()) rows.push_back({light, "even", "", "", "", ""});
  for (const LightSink& sink : sinks)
    rows.push_back({&sink == sinks.data() ? light : "", fmt::format("{:.0f}, {:.0f}", sink.x, sink.y),
                    fmt::format("{:.0f}", sink.radius), fmt::format("{:.1f}", sink.stops),
                    fmt::format("{:.0f}", sink.sigmas), outsideText(sink)});
}

int run(const SinksCommand& arguments, Terminal& terminal) {
  const SolveOptions options = arguments.solve.resolveFor(arguments.source);
  const Progress progress = terminal.progress();
  const SolvedSet set = arguments.edits.applyTo(
      openSource(*programConfig(), arguments.source, options, progress.part(0, 0.7F)));
  sayWarnings(set.capture.warnings, terminal);
  const std::vector<Image> maps = illuminationMaps(set, {}, progress.part(0.7F, 1));

  std::vector<std::vector<std::string>> rows{{"light", "pool at", "radius", "stops", "sigmas", ""}};
  Json lights = Json::object();
  for (size_t i = 0; i < maps.size(); ++i) {
    const std::string& name = set.capture.lights[i].name;
    const std::vector<LightSink> sinks = findSinks(maps[i]);
    addRows(rows, name, sinks);
    Json found = Json::array();
    for (const LightSink& sink : sinks) found.push_back(jsonFromSink(sink));
    lights[name] = {{"lamps", lampCount(sinks, maps[i])}, {"sinks", std::move(found)}};
  }
  terminal.result(tableText(rows),
                  {{"width", set.width()}, {"height", set.height()}, {"lights", std::move(lights)}});
  return 0;
}

}  // namespace

void addSinksVerb(Program& program) {
  const auto a = std::make_shared<SinksCommand>();
  CLI::App& verb =
      program.addVerb("sinks", "Where each light's pool lies, how broad it is, how many lamps made it",
                      [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SOURCE", a->source, "A solved set, or a capture to solve")->required();
  a->edits.addTo(verb);
  a->solve.addTo(verb);
}

}  // namespace swaplight
