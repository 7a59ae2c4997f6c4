#include <array>

#include "app/arguments/camera_look_arguments.h"
#include "app/arguments/display_arguments.h"
#include "app/arguments/grade_arguments.h"
#include "app/arguments/lighting_arguments.h"
#include "app/arguments/look_frame.h"
#include "app/arguments/memory_arguments.h"
#include "app/arguments/sequence_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/export/frame_export.h"
#include "core/export/provenance.h"
#include "core/file/frame_range.h"
#include "core/file/same_file.h"
#include "core/image/io/image_io.h"
#include "core/image/layer_parts.h"
#include "core/measure/luminance_histogram.h"
#include "core/relight/relight.h"
#include "core/relight/setting.h"
#include "core/session/session_parts.h"

namespace swaplight {
namespace {

struct RelightCommand {
  LightingArguments lighting;
  SequenceArguments sequence;
  CameraLookArguments cameraLook;
  GradeArguments grade;
  MemoryArguments memory;
  std::string frame;
  std::string tone;
  std::string histogram;
  FrameOptions output;
};

/// A session's view holds where the picture goes through one and the command line names none.
FrameOptions outputOf(const RelightCommand& arguments, const std::optional<Session>& session) {
  FrameOptions output = arguments.output;
  output.display.grade = arguments.grade.grade();
  if (!arguments.tone.empty()) output.tone = stillToneFromText(arguments.tone);
  if (output.tone && arguments.sequence.given())
    throw InputError(
        "--tone {}: looks at each frame by itself, so that a sequence would flicker; take a view, as --view "
        "Hable",
        arguments.tone);
  return frameOptionsFor(session ? session->document.display : DisplayChoice{}, arguments.frame, output);
}

/// Luminance under unit white and under the rig, as a plot; gives the figures.
Json writeHistogram(const ColorConfig& config, const SolvedSet& set, const Rig& rig,
                    const std::string& file) {
  const std::vector<NamedHistogram> histograms = {
      {"before", luminanceHistogram(sumAtUnitWhite(set))},
      {"after", luminanceHistogram(relight(set, rigFactors(config, rig, set.colorSpace()), rig.ambient))}};
  writeImage(drawLuminanceHistograms(histograms), file);
  return {{"before", jsonFromHistogram(histograms[0].histogram)},
          {"after", jsonFromHistogram(histograms[1].histogram)}};
}

/// Light that half float cannot hold is clipped where half was asked for; without --type the frame becomes
/// float.
void warnOfClipping(const ColorConfig& config, const RelightCommand& arguments, const SolvedSet& set,
                    const Rig& rig, Terminal& terminal) {
  if (arguments.output.write.pixelType != "half") return;
  const Image frame = relight(set, rigFactors(config, rig, set.colorSpace()), rig.ambient);
  if (!fitsHalf(frame))
    terminal.say("warning: {}: light brighter than half float can hold (65504) is clipped; leave out --type",
                 arguments.frame);
}

/// A still has its number where its file's name has a place for one.
void nameStill(RelightCommand& arguments) {
  arguments.sequence.check();
  if (arguments.sequence.given() || !hasFrameNumber(arguments.frame)) return;
  if (!arguments.cameraLook.givenFrame())
    throw InputError(
        "{}: has a place for a frame's number, and none is given: add -F 1-24 for a sequence, --frame 12 for "
        "a still, or write a name without #, @ and %d",
        arguments.frame);
  arguments.frame = stillName(arguments.frame, arguments.cameraLook.givenFrame());
}

int run(const RelightCommand& arguments, Terminal& terminal) {
  const std::optional<Session> session = arguments.lighting.session();
  const std::shared_ptr<const ColorConfig> config = LightingArguments::colors(session);
  if (session) sayWarnings(session->warnings, terminal);
  const std::filesystem::path source = arguments.lighting.source(session);
  FrameOptions output = outputOf(arguments, session);

  // Say what is wrong before the work, not after it.
  checkFrame(*config, arguments.frame, output);
  if (!arguments.output.colorSpace.empty() && !arguments.output.linear && !isSceneLinear(arguments.frame))
    throw InputError(
        "--color-space {}: is of scene-linear frames: write EXR or HDR, or add --linear; for a picture to be "
        "looked at, give --display and --view",
        arguments.output.colorSpace);
  if (arguments.sequence.given() && !arguments.histogram.empty())
    throw InputError("--histogram is of one frame: leave it out, or --frames");
  if (arguments.sequence.given() && arguments.cameraLook.givenFrame())
    throw InputError("--frame is the number of a still: leave it out, -F numbers the frames");
  const std::shared_ptr<CameraLook> look = arguments.cameraLook.look(session, terminal);
  std::unique_ptr<const ImagesInFiles> large = arguments.memory.filesBeside(arguments.frame, terminal);
  if (look && !large)  // the set, too: lights are read one after the other
    large = largeImagesBeside(arguments.frame, arguments.cameraLook.partSide());
  output.cameraLook = look;
  output.frameNumber = arguments.cameraLook.frame();
  if (arguments.sequence.given())
    return codeWithLook(
        arguments.sequence.run(*config, arguments.lighting, session, arguments.frame, output, terminal),
        look.get());
  std::vector<std::filesystem::path> inputs = arguments.lighting.inputs(session);
  for (const std::filesystem::path& file : arguments.cameraLook.inputs(look.get())) inputs.push_back(file);
  for (const std::filesystem::path& file : arguments.grade.inputs()) inputs.push_back(file);
  if (!arguments.histogram.empty()) checkFrame(*config, arguments.histogram, {});
  checkOutputs(std::array<std::filesystem::path, 2>{arguments.frame, arguments.histogram}, inputs);
  arguments.lighting.check(*config, session);

  const Progress progress = terminal.progress();
  const SolvedSet set = arguments.lighting.open(*config, session, progress.part(0, 0.8F));
  sayWarnings(set.capture.warnings, terminal);
  const Rig rig = arguments.lighting.rig(session, set.capture, &set);
  warnOfClipping(*config, arguments, set, rig, terminal);
  if (isSceneLinear(arguments.frame)) output.write.text = provenanceOf(set, rig, source);
  exportFrame(*config, set, rig, arguments.frame, output, progress.part(0.9F, 1));

  Json json{{"frame", arguments.frame}, {"source", source.string()},       {"width", set.width()},
            {"height", set.height()},   {"color_space", set.colorSpace()}, {"rig", jsonFromRig(rig)}};
  for (const LightSetting& light : rig.lights)
    terminal.detail("  {:<12} {}", light.light, settingText(light));
  const std::string contents = frameContents(*config, arguments.frame, output);
  terminal.say("wrote {}, {} x {} pixels, {}", arguments.frame, set.width(), set.height(), contents);
  json["contents"] = contents;
  if (!arguments.histogram.empty()) {
    json["luminance"] = writeHistogram(*config, set, rig, arguments.histogram);
    terminal.say("wrote {}", arguments.histogram);
  }
  if (const ColorGrade* grade = output.seenThrough.actingGrade()) json["grade"] = jsonFromGrade(*grade);
  if (look) json["camera_look"] = jsonFromPipeline(look->pipeline());
  if (look) json["left_out"] = look->leftOut();
  terminal.result("", json);
  return codeWithLook(0, look.get());
}

}  // namespace

void addRelightVerb(Program& program) {
  const auto a = std::make_shared<RelightCommand>();
  CLI::App& verb =
      program.addVerb("relight", "Relight a set: render a frame or a sequence", [a](Terminal& terminal) {
        nameStill(*a);
        return run(*a, terminal);
      });
  a->lighting.addTo(verb);
  a->sequence.addTo(verb);
  a->cameraLook.addTo(verb);
  a->grade.addTo(verb);
  a->memory.addTo(verb);
  verb.add_option(
          "-o,--output", a->frame,
          "The frame: EXR or HDR of scene-linear light, or PNG, TIFF or JPEG through --view, else the "
          "session's view, else plain sRGB")
      ->required()
      ->type_name("FRAME");
  addDisplayOptions(verb, a->output.display);
  verb.add_option("--tone", a->tone,
                  "Tone map a still by the whole picture: drago, mantiuk or reinhard; with parameters, as "
                  "drago:bias=0.9,saturation=1.1")
      ->type_name("NAME");
  verb.add_option("--color-space", a->output.colorSpace,
                  "Scene-linear in these primaries: lin_rec709, acescg, aces2065_1 ... (default: the set's)")
      ->type_name("NAME");
  verb.add_option("--histogram", a->histogram, "Plot luminance before (unit white) and after")
      ->type_name("FILE.png");
  verb.add_flag("--linear", a->output.linear, "Write scene-linear pixels, whatever the format");
  verb.add_option("--type", a->output.write.pixelType,
                  "half, float, uint8 or uint16 (default: as the format has it)")
      ->type_name("TYPE");
  verb.add_option("--compression", a->output.write.compression,
                  "EXR: none, rle, zips, zip (default), piz, pxr24, b44, b44a, dwaa, dwab")
      ->type_name("NAME");
}

}  // namespace swaplight
