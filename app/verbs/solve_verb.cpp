#include <algorithm>
#include <array>
#include <optional>

#include "app/arguments/camera_look_arguments.h"
#include "app/arguments/flat_arguments.h"
#include "app/arguments/leave_out_argument.h"
#include "app/arguments/memory_arguments.h"
#include "app/arguments/solve_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/capture_pixels.h"
#include "core/capture/left_out.h"
#include "core/capture/response_curve.h"
#include "core/export/filtered_set.h"
#include "core/file/json_file.h"
#include "core/file/same_file.h"
#include "core/intake/replaced_colors.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"
#include "core/set/set_color_space.h"
#include "core/set/solve_verdict.h"
#include "core/set/solved_file.h"
#include "core/solve/solve_photographs.h"

namespace swaplight {
namespace {

struct SolveCommand {
  std::string capture;
  std::string output;
  std::string report;
  std::string colorSpace;
  std::string colors;
  std::string response;
  std::string tone = "sure";
  std::vector<std::string> leftOut;
  SolvedFileOptions file;
  SolveArguments solve;
  FlatArguments flats;
  MemoryArguments memory;
  FilterRequest shotLook;
};

/// Those that have not been said already, or are about to be.
std::vector<std::string> warningsOfSolve(const SolveReport& report,
                                         const std::vector<std::vector<std::string>>& said) {
  std::vector<std::string> fresh;
  for (const std::string& warning : report.warnings)
    if (std::none_of(said.begin(), said.end(), [&](const auto& list) {
          return std::find(list.begin(), list.end(), warning) != list.end();
        }))
      fresh.push_back(warning);
  return fresh;
}

/// What the photographs are seen through before they are solved; null: nothing.
std::shared_ptr<CameraLook> shotLook(const SolveCommand& arguments, Terminal& terminal) {
  if (arguments.shotLook.empty()) return nullptr;
  const bool typed = arguments.shotLook.look.empty();
  auto look = readyLook(arguments.shotLook.pipeline(), typed ? "--shot-filter" : arguments.shotLook.look,
                        typed, {}, terminal);
  checkPlace(*look, "shot");
  return look;
}

int run(const SolveCommand& arguments, Terminal& terminal) {
  SolveOptions options = arguments.solve.resolve();
  options.correctTone = remedyFromText("--tone", arguments.tone, "declared", "auto");
  const std::shared_ptr<const ColorConfig> config = programConfig();
  Capture capture = readCapture(*config, sourceFile(arguments.capture));
  capture = withShotsLeftOut(std::move(capture), arguments.leftOut, "--leave-out");
  if (!arguments.colors.empty())
    capture = withReplacedColors(std::move(capture), namedUnknowns(shotColorsFromText(arguments.colors)));
  if (!arguments.response.empty()) {
    checkResponseFile(arguments.response, "--response");
    capture.colorSpace = pathInManifest(capture.folder, arguments.response);
  }
  capture = withFlats(capture, arguments.flats.lamps(capture.folder), arguments.flats.lens(capture.folder));
  sayWarnings(capture.warnings, terminal);
  checkSetColorSpace(arguments.colorSpace);
  std::vector<std::filesystem::path> inputs = filesOfSource(arguments.capture);
  for (const std::filesystem::path& flat : arguments.flats.files()) inputs.push_back(flat);
  if (!arguments.response.empty()) inputs.emplace_back(arguments.response);
  checkSolvedFile(arguments.output);
  checkOutputs(std::array<std::filesystem::path, 2>{arguments.output, arguments.report}, inputs);

  const std::shared_ptr<CameraLook> look = shotLook(arguments, terminal);
  const std::unique_ptr<const ImagesInFiles> large = arguments.memory.filesBeside(arguments.output, terminal);

  const Progress progress = terminal.progress();
  CapturePixels pixels = loadCapturePixels(*config, capture, progress.part(0, look ? 0.1f : 0.2f));
  if (look) filterShots(*config, pixels, *look, progress.part(0.1f, 0.2f));
  sayWarnings(pixels.warnings, terminal);
  const FlatFields fields = loadFlatFields(*config, capture, progress.part(0.2f, 0.2f));
  const std::vector<std::string> saidOfPixels = pixels.warnings;
  SolvedSet set = solvePhotographs(capture, std::move(pixels), fields, options, progress.part(0.2f, 0.8f));
  const SolveVerdict verdict = verdictOf(*set.report);
  sayWarnings(warningsOfSolve(*set.report, {capture.warnings, saidOfPixels, verdict.reasons}), terminal);
  set = inColorSpace(*config, std::move(set), arguments.colorSpace);
  writeSolvedSet(set, arguments.output, arguments.file, progress.part(0.8f, 1));
  if (!arguments.report.empty()) writeJson(jsonFromSolveReport(*set.report), arguments.report);

  Json json = jsonFromSolveReport(*set.report);
  json["solved"] = arguments.output;
  json["verdict"] = {{"word", verdictWord(verdict.word)}, {"reasons", verdict.reasons}};
  terminal.say("wrote {}, {} x {} pixels, {} lights", arguments.output, set.width(), set.height(),
               set.lightCount());
  const std::string unseen = unseenWords(set.report->causes);
  terminal.result(fmt::format("{}\n{} {:.2f} s.\n{}{}", verdictLine(verdict), set.report->message,
                              set.report->seconds, unseen, unseen.empty() ? "" : "\n"),
                  json);
  return codeWithLook(0, look.get());
}

}  // namespace

void addSolveVerb(Program& program) {
  const auto a = std::make_shared<SolveCommand>();
  CLI::App& verb = program.addVerb("solve", "Separate the lights of a capture",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("CAPTURE", a->capture, "capture.json, or the folder that holds it")->required();
  verb.add_option("-o,--output", a->output, "The solved set")->required()->type_name("SOLVED.exr");
  verb.add_option("--report", a->report, "Write the solver's report")->type_name("FILE.json");
  verb.add_option(
          "--color-space", a->colorSpace,
          "Working space of the set: lin_rec709, acescg or aces2065_1 (default: that of the photographs)")
      ->type_name("NAME");
  verb.add_option("--colors", a->colors,
                  "Other colours for the gels of the first photograph, one per light, wherever they went on; "
                  "?a: unknown, the same gel everywhere")
      ->type_name("LIST");
  verb.add_option(
          "--response", a->response,
          "The camera's response, as swaplight response writes it, instead of the capture's color_space")
      ->type_name("CURVE.csv");
  verb.add_flag("--multipart", a->file.multipart, "Multi-part EXR, one part per light, instead of layers");
  verb.add_flag("--float", a->file.floatPictures, "Contributions as 32-bit float instead of half");
  verb.add_flag("--half", a->file.halfSum,
                "R G B, their sum, as half instead of 32-bit float: a smaller file");
  verb.add_option("--tone", a->tone,
                  "auto: a tone curve that is seen in the photographs is taken off. sure: where nothing else "
                  "can be what "
                  "is wrong. declared: they are coded as the capture says")
      ->type_name("HOW")
      ->capture_default_str();
  verb.add_option("--shot-look", a->shotLook.look,
                  "Solve the photographs as a camera look makes them: by name or FILE.swaplook")
      ->type_name("NAME");
  verb.add_option(
          "--shot-filter", a->shotLook.filters,
          "A filter on every photograph before it is solved, with its parameters; again for the next one")
      ->type_name("NAME,param=value")
      ->expected(1)
      ->take_all();
  addLeaveOut(verb, a->leftOut);
  a->flats.addTo(verb);
  a->memory.addTo(verb);
  a->solve.addTo(verb);
}

}  // namespace swaplight
