#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "app/arguments/solve_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/base/number_text.h"
#include "core/capture/no_such_light.h"
#include "core/file/same_file.h"
#include "core/image/io/image_io.h"
#include "core/normals/lamp_place_json.h"
#include "core/normals/normal_fit.h"
#include "core/normals/placed_lights.h"
#include "core/normals/relief.h"
#include "core/normals/surface_normals.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"
#include "core/shadow/detect/detect_shadows.h"

namespace swaplight {
namespace {

constexpr double kLeastKnown = 0.4;  // of the pixels: below, lamps cannot be placed by them either

struct NormalsCommand {
  std::string source;
  SolveArguments solve;
  std::vector<std::string> lamps;
  std::string file;
};

/// A lamp as the option names it.
struct NamedPlace {
  std::string light;
  LampPlace place;
};

InputError notAPlace(const std::string& text) {
  return InputError(
      "--lamp {}: write LIGHT=AZIMUTH,ELEVATION,DISTANCE or LIGHT=AZIMUTH,ELEVATION,DISTANCE,STOPS: degrees "
      "to the right of the camera (-180 to 180), degrees up (-90 to 90), widths of the picture or far, stops",
      text);
}

std::vector<std::string> partsOf(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// LIGHT=AZIMUTH,ELEVATION,DISTANCE[,STOPS].
NamedPlace placeFromOption(const std::string& text) {
  const auto number = [&](const std::string& part, double least, double most) {
    const std::optional<float> value = numberFromText(part);
    if (!value || *value < least || *value > most) throw notAPlace(text);
    return *value;
  };
  const size_t sign = text.find('=');
  if (sign == std::string::npos) throw notAPlace(text);
  const std::vector<std::string> parts = partsOf(text.substr(sign + 1));
  if (parts.size() < 3 || parts.size() > 4) throw notAPlace(text);
  NamedPlace named{text.substr(0, sign), {}};
  named.place.azimuth = number(parts[0], -180, 180);
  named.place.elevation = number(parts[1], -90, 90);
  if (parts[2] != "far") named.place.distance = number(parts[2], 0, kFarthestLamp);
  if (parts.size() == 4) named.place.stops = number(parts[3], -kMostLampStops, kMostLampStops);
  return named;
}

LampPlaces placesOf(const NormalsCommand& arguments) {
  LampPlaces places;
  std::optional<bool> metered;
  for (const std::string& text : arguments.lamps) {
    const NamedPlace named = placeFromOption(text);
    if (!places.emplace(named.light, named.place).second)
      throw InputError("--lamp {}: {} was given a place already", text, named.light);
    if (!metered) metered = named.place.stops.has_value();
    if (named.place.stops.has_value() != *metered)
      throw InputError("--lamp {}: say the stops of all lamps, or of none", text);
  }
  if (places.size() < kFewestLamps)
    throw InputError("--lamp: normals need {} lamps or more, {} given", kFewestLamps, places.size());
  return places;
}

/// Those lamps of the set that can be used; says which cannot.
std::vector<PlacedLight> usedLamps(const LampPlaces& places, const Capture& capture,
                                   const std::string& source, Terminal& terminal) {
  PlacedLights placed = placedLights(places, capture, source);
  if (!placed.tooNear.empty())
    terminal.say("warning: {}: not used, nearer than {} widths of the picture: {}", source,
                 LampPlace::kNearest, fmt::join(placed.tooNear, ", "));
  return std::move(placed.lamps);
}

/// All layers in one picture.
Image layersOf(const SurfaceNormals& found) {
  const Image depth = reliefOf(found.normals);
  Image layers(ImageSpec{
      found.normals.width(),
      found.normals.height(),
      {"normal.X", "normal.Y", "normal.Z", "depth.Z", "reflectance.R", "reflectance.G", "reflectance.B"},
      "data"});
  const size_t pixels = found.normals.pixelCount();
  for (int c = 0; c < 3; ++c) {
    std::copy_n(found.normals.plane(c), pixels, layers.plane(c));
    std::copy_n(found.reflectance.plane(c), pixels, layers.plane(4 + c));
  }
  std::copy_n(depth.plane(0), pixels, layers.plane(3));
  return layers;
}

void sayResult(const NormalsCommand& arguments, const SurfaceNormals& found, Terminal& terminal) {
  const auto pixels = static_cast<double>(found.normals.pixelCount());
  const auto share = [&](size_t count) { return static_cast<double>(count) / pixels; };
  const RefusedPixels& refused = found.refused;
  const size_t known = found.normals.pixelCount() - refused.count();
  terminal.say("wrote {}, {} x {} pixels", arguments.file, found.normals.width(), found.normals.height());
  if (known > 0 && found.checked < known / 2)
    terminal.say(
        "warning: {}: {:.0f} % of the normals come from three lamps, which nothing checks: they are as right "
        "as the lamps' places",
        arguments.source, 100. * static_cast<double>(known - found.checked) / static_cast<double>(known));
  if (static_cast<double>(known) < kLeastKnown * pixels)
    terminal.say("warning: {}: only {:.0f} % of the pixels have a normal", arguments.source,
                 100 * share(known));
  if (found.isContradictory())
    terminal.say(
        "warning: {}: the lamps disagree on {:.0f} % of the pixels that four or more light: check their "
        "places",
        arguments.source,
        100. * static_cast<double>(refused.disagreed + found.shadowed) /
            static_cast<double>(refused.disagreed + found.checked));
  terminal.result(
      fmt::format("refused {:.1f} % of the pixels: not measured {:.1f} %, fewer than three lamps {:.1f} %, "
                  "lamps too much alike {:.1f} %, lamps disagree {:.1f} %, turned away {:.1f} %\n",
                  100 * share(refused.count()), 100 * share(refused.flagged), 100 * share(refused.fewLamps),
                  100 * share(refused.alike), 100 * share(refused.disagreed), 100 * share(refused.away)),
      {{"file", arguments.file},
       {"refused", share(refused.count())},
       {"flagged", share(refused.flagged)},
       {"few_lamps", share(refused.fewLamps)},
       {"alike", share(refused.alike)},
       {"disagree", share(refused.disagreed)},
       {"away", share(refused.away)},
       {"checked", share(found.checked)},
       {"shadowed", share(found.shadowed)}});
}

int run(const NormalsCommand& arguments, Terminal& terminal) {
  const LampPlaces places = placesOf(arguments);
  SolveOptions solving = arguments.solve.resolveFor(arguments.source);
  solving.highlights = false;  // nothing here looks at them
  if (lowerExtension(arguments.file) != ".exr")
    throw InputError("{}: normals are written as OpenEXR. Name it {}.", arguments.file,
                     std::filesystem::path(arguments.file).replace_extension(".exr").string());
  checkOutput(arguments.file, filesOfSource(arguments.source));

  const Progress progress = terminal.progress();
  const SolvedSet set = openSource(*programConfig(), arguments.source, solving, progress.part(0, 0.4F));
  sayWarnings(set.capture.warnings, terminal);
  const std::vector<PlacedLight> lamps = usedLamps(places, set.capture, arguments.source, terminal);
  std::vector<std::shared_ptr<const LightShadows>> shadows;
  for (LightShadows& light : detectShadows(set, {}, progress.part(0.4F, 0.9F)))
    shadows.push_back(std::make_shared<const LightShadows>(std::move(light)));
  const auto shadowsOf = [&](const std::string& light) {
    return shadows[placeOfLight(set.capture, light, arguments.source)];
  };
  const SurfaceNormals found = surfaceNormals(set, shadowsOf, lamps, progress.part(0.9F, 1));
  if (found.refused.count() == found.normals.pixelCount())
    throw InputError(
        "{}: on no pixel can it be told how the surface is turned: three lamps that light the same things "
        "must not stand in one line. Check --lamp.",
        arguments.source);
  WriteOptions output;
  output.pixelType = "float";
  writeImage(layersOf(found), arguments.file, output);
  sayResult(arguments, found, terminal);
  return 0;
}

}  // namespace

void addNormalsVerb(Program& program) {
  const auto a = std::make_shared<NormalsCommand>();
  CLI::App& verb =
      program.addVerb("normals", "How surfaces are turned, from three lamps or more whose places are told",
                      [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SOURCE", a->source, "A solved set, or a capture to solve")->required();
  verb.add_option(
          "--lamp", a->lamps,
          "Where a lamp stood, seen from the middle of the set: degrees to the right of the camera (-90: "
          "left, 180: behind the set), degrees up, its distance in widths of the picture there or far, "
          "and, of all lamps or none, what a meter reads that points to it; once a lamp")
      ->required()
      ->allow_extra_args(false)
      ->type_name("LIGHT=AZIMUTH,ELEVATION,DISTANCE[,STOPS]");
  verb.add_option("-o,--output", a->file,
                  "EXR: normal.X right, normal.Y up, normal.Z to the camera; depth.Z; reflectance.R, G, B")
      ->required()
      ->type_name("FILE.exr");
  a->solve.addWithoutHighlightsTo(verb);
}

}  // namespace swaplight
