#include "app/arguments/camera_look_arguments.h"
#include "app/arguments/lighting_arguments.h"
#include "app/program/description.h"
#include "app/program/number_range.h"
#include "app/session_verbs/session_verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/export/frame_file.h"
#include "core/file/same_file.h"
#include "core/report/contact_sheet.h"
#include "core/session/open_source.h"
#include "core/set/set_color_space.h"

namespace swaplight {
namespace {

struct VersionsCommand {
  std::string session;
  std::string sheet;
  int columns = 0;
  int width = GalleryOptions{}.width;
};

/// The set of a session, in its working space; its edits are its versions'.
std::shared_ptr<const SolvedSet> setOf(const ColorConfig& config, const Document& document,
                                       const Progress& progress) {
  SolvedSet set = openSource(config, document.source, document.solve, progress);
  return std::make_shared<const SolvedSet>(inColorSpace(config, std::move(set), document.workingSpace));
}

void writeSheet(const VersionsCommand& arguments, const Session& session, Terminal& terminal) {
  const Document& document = session.document;
  if (document.looks.empty())
    throw InputError("{}: its gallery is empty: keep looks or versions in the studio first",
                     arguments.session);
  checkSheetFile(arguments.sheet);
  std::vector<std::filesystem::path> inputs = filesOfSource(document.source);
  inputs.emplace_back(arguments.session);
  checkOutput(arguments.sheet, inputs);
  const std::shared_ptr<const ColorConfig> config = LightingArguments::colors(session);
  const Progress progress = terminal.progress();
  const auto set = setOf(*config, document, progress.part(0, 0.5F));
  GalleryOptions options;
  options.width = arguments.width;
  options.cameraLook = versionLooks(terminal);
  const auto pictures = galleryPictures(*config, set, document, options, progress.part(0.5F, 0.9F));
  Image sheet =
      contactSheet(pictures, std::filesystem::path(arguments.session).stem().string(), arguments.columns);
  const int width = sheet.width(), height = sheet.height();
  writeCodes(std::move(sheet), arguments.sheet, {}, {});
  terminal.say("wrote {}, {} x {} pixels", arguments.sheet, width, height);
}

int run(const VersionsCommand& arguments, Terminal& terminal) {
  const Session session = readSession(arguments.session);
  sayWarnings(session.warnings, terminal);
  if (!arguments.sheet.empty()) writeSheet(arguments, session, terminal);
  std::vector<std::vector<std::string>> rows{{"", "name", "kind", "note"}};
  Json json = Json::array();
  for (const SavedLook& look : session.document.looks) {
    const char* kind = look.scene ? "version" : "look";
    rows.push_back({std::to_string(rows.size()), look.name, kind, look.note});
    json.push_back({{"name", look.name}, {"kind", kind}, {"note", look.note}});
  }
  terminal.result(json.empty() ? "The gallery is empty.\n" : tableText(rows), {{"versions", json}});
  return 0;
}

}  // namespace

void addVersionsVerb(Program& program) {
  const auto a = std::make_shared<VersionsCommand>();
  CLI::App& verb =
      program.addVerb("versions", "List a session's looks and versions; draw them as a contact sheet",
                      [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SESSION", a->session, "A session (NAME.swaplight)")->required();
  verb.add_option("-o,--output", a->sheet, "The contact sheet: every one with its name and note")
      ->type_name("SHEET.png");
  verb.add_option("--columns", a->columns, "Pictures side by side (default: as fits a screen)")
      ->check(NumberRange(1, 12))
      ->type_name("N");
  verb.add_option("--width", a->width, "Of a picture, in pixels")
      ->check(NumberRange(64, 4096))
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace swaplight
