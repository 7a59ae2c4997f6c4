#include <fmt/ranges.h>

#include "app/arguments/camera_look_arguments.h"
#include "app/arguments/display_arguments.h"
#include "app/arguments/lighting_arguments.h"
#include "app/arguments/memory_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/export/layer_export.h"
#include "core/export/look_export.h"
#include "core/export/provenance.h"
#include "core/file/same_file.h"

namespace swaplight {
namespace {

struct ExportCommand {
  LightingArguments lighting;
  CameraLookArguments cameraLook;
  MemoryArguments memory;
  std::string file;
  std::string naming = "layers";
  std::string pictures = "half";
  std::string data = "float";
  std::string window;
  DisplayChoice display;
  LayerOptions options;
  std::vector<const CLI::Option*> ofLayers;  ///< what only an EXR has
  const CLI::Option* type = nullptr;         ///< of these, --type
};

PixelType floatTypeOf(const std::string& option, const std::string& name) {
  if (name == "half") return PixelType::Half;
  if (name == "float") return PixelType::Float;
  throw InputError("{} {}: give half or float", option, name);
}

/// True where an EXR's compression does not keep every bit of a layer's colours.
bool losesLight(const std::string& compression, PixelType type) {
  if (compression.starts_with("dwa")) return true;
  return type == PixelType::Half ? compression.starts_with("b44") : compression.starts_with("pxr24");
}

/// "shots", "full" or "X,Y,W,H".
std::optional<PixelRect> windowOf(const std::string& text, const SolvedSet& set) {
  if (text.empty() || text == "shots") return std::nullopt;
  if (text == "full") return PixelRect{0, 0, set.width(), set.height()};
  const std::optional<PixelRect> rect = rectFromText(text);
  if (!rect) throw InputError("--data-window {}: give shots, full or X,Y,WIDTH,HEIGHT in pixels", text);
  return rect;
}

LayerOptions optionsOf(const ExportCommand& arguments) {
  LayerOptions options = arguments.options;
  if (arguments.naming != "layers" && arguments.naming != "blender")
    throw InputError("--naming {}: give layers or blender", arguments.naming);
  options.naming = arguments.naming == "blender" ? LayerNaming::Blender : LayerNaming::Layers;
  options.pictures = floatTypeOf("--type", arguments.pictures);
  options.data = floatTypeOf("--data-type", arguments.data);
  return options;
}

/// A look's file holds no layers.
void checkLookFile(const ExportCommand& arguments) {
  for (const CLI::Option* option : arguments.ofLayers)
    if (option->count() > 0)
      throw InputError("{}: is of layers, and {} has none; write an EXR, or leave it out", option->get_name(),
                       arguments.file);
}

int exportLook(const ColorConfig& config, const ExportCommand& arguments,
               const std::optional<Session>& session, const SolvedSet& set, const Rig& rig,
               Terminal& terminal) {
  const GlobalLook look = globalLook(config, set, rig);
  writeLook(config, look, displayOver(session, arguments.display), arguments.file);
  terminal.say(
      "wrote {}: the global part of the look, {:.1f} % of the relit picture; what each light does on its "
      "own is spatial and not in it",
      arguments.file, 100 * look.explained);
  terminal.result("", {{"file", arguments.file},
                       {"gain", {look.gain.x, look.gain.y, look.gain.z}},
                       {"explained", look.explained}});
  return 0;
}

int run(const ExportCommand& arguments, Terminal& terminal) {
  const std::optional<Session> session = arguments.lighting.session();
  const std::shared_ptr<const ColorConfig> config = LightingArguments::colors(session);
  if (session) sayWarnings(session->warnings, terminal);
  LayerOptions options = optionsOf(arguments);
  const bool look = isLookFile(arguments.file);
  if (look) checkLookFile(arguments);
  if (look) config->checkView(displayOver(session, arguments.display));
  if (!options.colorSpace.empty()) config->checkLinear(options.colorSpace);
  const std::shared_ptr<CameraLook> seen = look ? nullptr : arguments.cameraLook.look(session, terminal);
  if (!look && !seen && !arguments.display.empty() && lowerExtension(arguments.file) == ".exr")
    throw InputError(
        "--view, --display, --view-look: layers are light, which no view changes: give --camera-look, "
        "write a .cube, or leave them out");
  std::vector<std::filesystem::path> inputs = arguments.lighting.inputs(session);
  for (const std::filesystem::path& file : arguments.cameraLook.inputs(seen.get())) inputs.push_back(file);
  checkOutput(arguments.file, inputs);
  arguments.lighting.check(*config, session);
  const std::unique_ptr<const ImagesInFiles> large = arguments.memory.filesBeside(arguments.file, terminal);

  const Progress progress = terminal.progress();
  const SolvedSet set = arguments.lighting.open(*config, session, progress.part(0, 0.6F));
  sayWarnings(set.capture.warnings, terminal);
  const Rig rig = arguments.lighting.rig(session, set.capture, &set);
  if (look) return exportLook(*config, arguments, session, set, rig, terminal);
  options.dataWindow = windowOf(arguments.window, set);
  options.text = provenanceOf(set, rig, arguments.lighting.source(session));
  options.cameraLook = seen;
  options.seenThrough = displayOver(session, arguments.display).withoutGrade();
  options.frameNumber = arguments.cameraLook.frame();
  const PixelType type = exportLayers(*config, set, rig, arguments.file, options, progress.part(0.6F, 1));
  if (arguments.type->count() > 0 && type != options.pictures)
    sayWarnings({"--type half: light is brighter than half can hold: the colour layers are 32-bit float"},
                terminal);
  if (options.highlights && set.highlights.empty())
    sayWarnings({"this set has no highlights: no layers LIGHT.spec are written"}, terminal);
  const std::vector<std::string> layers = exportedLayers(set, options);
  terminal.say("wrote {}, {} x {} pixels; the layers {} add up to the picture{}", arguments.file, set.width(),
               set.height(), fmt::join(layers, ", "),
               losesLight(options.compression, type) ? ", but for what the compression loses" : "");
  if (seen) terminal.say("the layer camera_look is the picture seen through \"{}\"", seen->pipeline().name);
  terminal.result("", {{"file", arguments.file},
                       {"layers", layers},
                       {"width", set.width()},
                       {"height", set.height()},
                       {"color_space", options.colorSpace.empty() ? set.colorSpace() : options.colorSpace},
                       {"left_out", seen ? seen->leftOut() : std::vector<std::string>{}},
                       {"rig", jsonFromRig(rig)}});
  return codeWithLook(0, seen.get());
}

}  // namespace

void addExportVerb(Program& program) {
  const auto a = std::make_shared<ExportCommand>();
  CLI::App& verb =
      program.addVerb("export", "Export every light as a layer for a compositor, or a look's global part",
                      [a](Terminal& terminal) {
                        a->file = stillName(a->file, a->cameraLook.givenFrame());
                        return run(*a, terminal);
                      });
  a->lighting.addTo(verb);
  verb.add_option(
          "-o,--output", a->file,
          "LAYERS.exr: every light as it shines under the rig, and their sum. LOOK.cube, .ccc or .cc: what "
          "of the look is the same for every pixel")
      ->required()
      ->type_name("FILE");
  const auto layers = [a](CLI::Option* option) {
    a->ofLayers.push_back(option);
    return option;
  };
  layers(verb.add_option("--naming", a->naming, "layers (LIGHT.R) or blender (ViewLayer.Combined_LIGHT.R)"))
      ->type_name("HOW")
      ->capture_default_str();
  layers(verb.add_flag("--multipart", a->options.multipart, "Multi-part EXR, one part per layer"));
  layers(verb.add_option("--compression", a->options.compression,
                         "none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab"))
      ->type_name("NAME")
      ->capture_default_str();
  a->type = layers(verb.add_option("--type", a->pictures, "half or float: the colour layers"))
                ->type_name("TYPE")
                ->capture_default_str();
  layers(verb.add_option("--color-space", a->options.colorSpace,
                         "Of the colour layers: lin_rec709, acescg, aces2065_1 ... (default: the set's)"))
      ->type_name("NAME");
  layers(verb.add_flag("--beta", a->options.beta, "Include the lights' beta maps (beta.LIGHT)"));
  layers(verb.add_flag("--spec", a->options.highlights,
                       "Include LIGHT.spec: what of each light is highlight, where the set knows it"));
  layers(verb.add_flag("--quality", a->options.quality, "Include the solver's residual, sigma and flags"));
  layers(verb.add_option("--data-type", a->data, "half or float: beta and quality"))
      ->type_name("TYPE")
      ->capture_default_str();
  layers(verb.add_option("--data-window", a->window,
                         "shots (as the photographs have it), full, or X,Y,WIDTH,HEIGHT"))
      ->type_name("WINDOW");
  a->cameraLook.addTo(verb);
  a->memory.addTo(verb);
  addDisplayOptions(*verb.add_option_group("For .cube and a camera look"), a->display);
}

}  // namespace swaplight
