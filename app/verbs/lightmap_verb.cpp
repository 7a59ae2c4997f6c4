#include <fmt/ranges.h>

#include <algorithm>

#include "app/arguments/display_arguments.h"
#include "app/arguments/lighting_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/capture/no_such_light.h"
#include "core/export/frame_export.h"
#include "core/export/layer_export.h"
#include "core/export/provenance.h"
#include "core/file/same_file.h"
#include "core/illumination/illumination.h"

namespace swaplight {
namespace {

constexpr double kMostSmoothing = 0.25;

struct LightmapCommand {
  LightingArguments lighting;
  std::vector<std::string> only;
  IlluminationOptions illumination;
  std::string file;
  FrameOptions output;
};

/// The indices of the lights that are asked for.
std::vector<size_t> lightsAskedFor(const LightmapCommand& arguments, const Capture& capture,
                                   const std::string& source) {
  std::vector<size_t> lights;
  for (size_t i = 0; i < capture.lights.size(); ++i) {
    const bool named = std::find(arguments.only.begin(), arguments.only.end(), capture.lights[i].name) !=
                       arguments.only.end();
    if (named || arguments.only.empty()) lights.push_back(i);
  }
  for (const std::string& name : arguments.only) static_cast<void>(placeOfLight(capture, name, source));
  return lights;
}

/// These lights of a set alone.
SolvedSet setOf(SolvedSet set, const std::vector<size_t>& lights) {
  std::vector<Light> kept;
  std::vector<Image> contributions;
  ImageSpec beta{set.width(), set.height(), {}, set.beta.spec().colorSpace};
  for (const size_t i : lights) {
    kept.push_back(set.capture.lights[i]);
    contributions.push_back(std::move(set.contributions[i]));
    beta.channels.push_back("beta." + kept.back().name);
  }
  set.capture.lights = std::move(kept);
  set.contributions = std::move(contributions);
  set.beta = Image(std::move(beta));
  updateBeta(set);
  return set;
}

Rig rigOf(const Rig& rig, const Capture& capture) {
  Rig chosen = rig;
  std::erase_if(chosen.lights,
                [&](const LightSetting& light) { return capture.lightIndex(light.light) < 0; });
  return chosen;
}

void check(const ColorConfig& config, const LightmapCommand& arguments, const FrameOptions& output) {
  checkFrame(config, arguments.file, output);
  arguments.lighting.refuseAmbient("a light map");
  const std::string& type = arguments.output.write.pixelType;
  if (lowerExtension(arguments.file) == ".exr" && (type == "uint8" || type == "uint16"))
    throw InputError("{}: an EXR holds half or float, not {}.", arguments.file, type);
  const double smoothing = arguments.illumination.smoothing;
  if (!(smoothing >= 0 && smoothing <= kMostSmoothing))
    throw InputError("--smooth {}: give widths of the picture, from 0 to {}", smoothing, kMostSmoothing);
}

/// Layers where the format has any, a picture otherwise.
void write(const ColorConfig& config, const LightmapCommand& arguments, const SolvedSet& grey, const Rig& rig,
           FrameOptions output, const std::filesystem::path& source, Terminal& terminal,
           const Progress& progress) {
  const auto text = provenanceOf(grey, rig, source);
  if (lowerExtension(arguments.file) == ".exr" && output.display == DisplayChoice{}) {
    LayerOptions layers;
    layers.text = text;
    if (output.write.pixelType == "float") layers.pictures = PixelType::Float;
    const PixelType type = exportLayers(config, grey, rig, arguments.file, layers, progress);
    if (output.write.pixelType == "half" && type != PixelType::Half)
      sayWarnings({"--type half: light is brighter than half can hold: the layers are 32-bit float"},
                  terminal);
    return;
  }
  if (isSceneLinear(arguments.file)) output.write.text = text;
  exportFrame(config, grey, rig, arguments.file, output, progress);
}

int run(const LightmapCommand& arguments, Terminal& terminal) {
  const std::optional<Session> session = arguments.lighting.session();
  const std::shared_ptr<const ColorConfig> config = LightingArguments::colors(session);
  if (session) sayWarnings(session->warnings, terminal);
  const FrameOptions output = frameOptionsFor(
      session ? session->document.display.withoutGrade() : DisplayChoice{}, arguments.file, arguments.output);
  check(*config, arguments, output);
  checkOutput(arguments.file, arguments.lighting.inputs(session));
  arguments.lighting.check(*config, session);

  const std::filesystem::path source = arguments.lighting.source(session);
  const Progress progress = terminal.progress();
  const SolvedSet set = arguments.lighting.open(*config, session, progress.part(0, 0.6F));
  sayWarnings(set.capture.warnings, terminal);
  const Rig rig = arguments.lighting.rig(session, set.capture, &set);
  const std::vector<size_t> lights = lightsAskedFor(arguments, set.capture, source.string());
  if (set.lightCount() < 2)
    terminal.say("warning: {}: with one light only, texture of one hue cannot be told from light",
                 source.string());
  const SolvedSet grey = setOf(greySet(set, arguments.illumination, progress.part(0.6F, 0.9F)), lights);
  write(*config, arguments, grey, rigOf(rig, grey.capture), output, source, terminal, progress.part(0.9F, 1));

  Json names = Json::array();
  for (const Light& light : grey.capture.lights) names.push_back(light.name);
  terminal.say("wrote {}, {} x {} pixels", arguments.file, grey.width(), grey.height());
  terminal.result("", {{"file", arguments.file},
                       {"width", grey.width()},
                       {"height", grey.height()},
                       {"color_space", grey.colorSpace()},
                       {"lights", std::move(names)}});
  return 0;
}

}  // namespace

void addLightmapVerb(Program& program) {
  const auto a = std::make_shared<LightmapCommand>();
  CLI::App& verb =
      program.addVerb("lightmap", "The light on the set without its texture: as if all of it were grey",
                      [a](Terminal& terminal) { return run(*a, terminal); });
  a->lighting.addTo(verb);
  verb.add_option("-o,--output", a->file,
                  "EXR: R G B under all lights, and a layer a light; or PNG, TIFF, JPEG, HDR: the sum")
      ->required()
      ->type_name("FILE");
  verb.add_option("--only", a->only, "This light only; may be repeated")->type_name("NAME");
  verb.add_option(
          "--smooth", a->illumination.smoothing,
          "Even out relief over this far, in widths of the picture, 0..0.25; 0: surfaces show how they "
          "are turned to the light")
      ->type_name("X")
      ->capture_default_str();
  addDisplayOptions(verb, a->output.display);
  verb.add_option("--type", a->output.write.pixelType,
                  "half, float, uint8 or uint16 (default: as the format has it)")
      ->type_name("TYPE");
}

}  // namespace swaplight
