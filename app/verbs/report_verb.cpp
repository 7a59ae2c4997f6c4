#include <array>

#include "app/arguments/camera_look_arguments.h"
#include "app/arguments/display_arguments.h"
#include "app/arguments/lighting_arguments.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/atomic_file.h"
#include "core/file/same_file.h"
#include "core/image/io/image_io.h"
#include "core/report/session_report.h"

namespace swaplight {
namespace {

struct ReportCommand {
  LightingArguments lighting;
  DisplayChoice display;
  std::string page;
  std::string histogram;
};

int run(const ReportCommand& arguments, Terminal& terminal) {
  const std::optional<Session> session = arguments.lighting.session();
  const std::shared_ptr<const ColorConfig> config = LightingArguments::colors(session);
  if (session) sayWarnings(session->warnings, terminal);
  config->checkView(arguments.display);
  checkOutputs(std::array<std::filesystem::path, 2>{arguments.page, arguments.histogram},
               arguments.lighting.inputs(session));
  checkEnding(arguments.page, std::array{".html", ".htm"}, "a report");
  arguments.lighting.check(*config, session);

  const Progress progress = terminal.progress();
  const auto unedited = std::make_shared<const SolvedSet>(
      arguments.lighting.openUnedited(*config, session, progress.part(0, 0.5F)));
  std::vector<GalleryPicture> versions;  // with edits of their own
  if (session && !session->document.looks.empty()) {
    GalleryOptions options;
    options.cameraLook = versionLooks(terminal);
    versions = galleryPictures(*config, unedited, session->document, options, progress.part(0.5F, 0.8F));
  }
  const std::shared_ptr<const SolvedSet> set = arguments.lighting.edited(unedited, session);
  sayWarnings(set->capture.warnings, terminal);
  const Rig rig = arguments.lighting.rig(session, set->capture, set.get());
  const SessionReport report({*config, *set, rig, displayOver(session, arguments.display),
                              arguments.lighting.source(session).filename().string(), std::move(versions)});
  progress.update(0.8F, "writing");
  writeFile(arguments.page, report.html());
  terminal.say("wrote {}", arguments.page);
  if (!arguments.histogram.empty()) {
    writeImage(report.histogram(), arguments.histogram);
    terminal.say("wrote {}", arguments.histogram);
  }
  const Json json = report.json();
  std::string text;
  for (const LightRange& range : report.ranges())
    text += fmt::format("{:<12} {}\n", range.light, rangeWords(range));
  terminal.result(text, json);
  return 0;
}

}  // namespace

void addReportVerb(Program& program) {
  const auto a = std::make_shared<ReportCommand>();
  CLI::App& verb = program.addVerb("report", "Write a printable HTML report of a set and its lighting",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  a->lighting.addTo(verb);
  verb.add_option("-o,--output", a->page, "The HTML page, self-contained")
      ->required()
      ->type_name("REPORT.html");
  addDisplayOptions(verb, a->display);
  verb.add_option("--histogram", a->histogram, "Write luminance before and after as a plot")
      ->type_name("FILE.png");
}

}  // namespace swaplight
