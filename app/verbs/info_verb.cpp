#include <fmt/ranges.h>

#include <algorithm>
#include "app/program/description.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/left_out.h"
#include "core/file/json_file.h"
#include "core/image/io/image_io.h"
#include "core/ocio/chosen_config.h"
#include "core/relight/setting.h"
#include "core/session/open_source.h"
#include "core/session/session_file.h"
#include "core/set/dynamic_range.h"
#include "core/set/set_color_space.h"
#include "core/set/solve_verdict.h"
#include "core/set/solved_file.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

std::string pictureText(const ImageSpec& spec, const ImageFileInfo& info) {
  return fmt::format("{} x {} pixels, {} {}{}, {}", spec.width, spec.height, info.format, info.pixelType,
                     info.parts > 1 ? fmt::format(" in {} parts", info.parts) : "", spec.colorSpace);
}

Json pictureJson(const ImageSpec& spec, const ImageFileInfo& info) {
  return {{"width", spec.width},          {"height", spec.height}, {"format", info.format},
          {"pixel_type", info.pixelType}, {"parts", info.parts},   {"color_space", spec.colorSpace},
          {"channels", spec.channels}};
}

/// All of them are in the JSON.
std::string channelsText(const ImageSpec& spec) {
  constexpr size_t kShown = 100;
  const size_t count = spec.channels.size();
  const auto end = spec.channels.begin() + static_cast<ptrdiff_t>(std::min(count, kShown));
  const std::string more = count > kShown ? fmt::format(" and {} more", count - kShown) : "";
  return fmt::format("{}{}", fmt::join(spec.channels.begin(), end, " "), more);
}

std::string lightsText(const Capture& capture) {
  std::vector<std::string> names;
  for (const Light& light : capture.lights)
    names.push_back(light.role == Role::Other || roleName(light.role) == light.name
                        ? light.name
                        : fmt::format("{} ({})", light.name, roleName(light.role)));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string shotsText(const Capture& capture) {
  std::vector<std::vector<std::string>> rows{{"shot", "stops"}};
  for (const Light& light : capture.lights) rows.front().push_back(light.name);
  for (const Shot& shot : capture.shots) {
    rows.push_back({shot.image, fmt::format("{:+.2f}", shot.exposureStops)});
    for (size_t i = 0; i < shot.lightColors.size(); ++i) {
      const std::optional<Rgb>& color = shot.lightColors[i];
      const std::string name = shot.colorName(i);
      rows.back().push_back(color ? fmt::format("{:.3f} {:.3f} {:.3f}", color->x, color->y, color->z)
                                  : (name.empty() ? "unknown" : name));
    }
  }
  return tableText(rows);
}

Description describeCapture(const fs::path& file) {
  const Capture capture = readCapture(*programConfig(), file);
  ImageFileInfo info;
  const ImageSpec spec = readImageSpec(capture.folder / capture.shots.front().image, &info);
  Description d;
  d.text = fmt::format("{}: capture \"{}\"\n", file.string(), printable(capture.name));
  d.line("pictures", fmt::format("{} x {} pixels, {} {}, {}", spec.width, spec.height, info.format,
                                 info.pixelType, capture.colorSpace));
  d.line("lights", lightsText(capture));
  if (const auto leftOut = leftOutOf(capture); !leftOut.empty()) d.line("left out", leftOutWords(leftOut));
  if (capture.noise)
    d.line("noise", fmt::format("read {}, full well {}", capture.noise->read, capture.noise->fullWell));
  if (capture.ambient) d.line("ambient", *capture.ambient);
  if (capture.dark) d.line("dark", *capture.dark);
  for (const std::string& warning : capture.warnings) d.line("warning", warning);
  d.text += "\n" + shotsText(capture);
  d.json = {{"kind", "capture"}, {"file", file.string()}};
  d.json.update(pictureJson(spec, info));
  d.json["color_space"] = capture.colorSpace;
  d.json["capture"] = jsonFromCapture(capture);
  d.json["warnings"] = capture.warnings;
  return d;
}

/// The range of each light, from the header, or from the pixels of an older file.
void describeRange(const fs::path& file, const ImageFileInfo& info, Description& d) {
  const auto said = info.text.find(kSolvedRanges);
  const std::string where = file.string() + ": " + kSolvedRanges;
  const std::vector<LightRange> ranges = said != info.text.end()
                                             ? rangesFromJson(parseJson(said->second, where), where)
                                             : dynamicRange(readSolvedSet(file));
  d.json["dynamic_range"] = jsonFromRanges(ranges);
  for (const LightRange& range : ranges) d.line("range", range.light + ": " + rangeWords(range));
}

/// Of which lights the file holds them; empty where it holds none.
std::string highlightsText(const ImageSpec& spec, const Capture& capture,
                           const std::optional<SolveReport>& report) {
  std::vector<std::string> lights;
  for (const Light& light : capture.lights)
    if (holdsHighlights(spec, light.name)) lights.push_back(light.name);
  if (lights.empty()) return {};
  const double part = report ? report->highlights : 0;
  return fmt::format("of {}{}", fmt::join(lights, ", "),
                     part > 0 ? fmt::format(", in {:.2f} % of the picture", 100 * part) : "");
}

Description describeSolvedSet(const fs::path& file) {
  const auto [spec, info, capture, report] = readSolvedHeader(file);
  Description d;
  d.text = fmt::format("{}: solved set \"{}\"\n", file.string(), printable(capture.name));
  d.line("pictures", pictureText(spec, info));
  d.line("lights", lightsText(capture));
  if (const auto leftOut = leftOutOf(capture); !leftOut.empty()) d.line("left out", leftOutWords(leftOut));
  d.line("channels", channelsText(spec));
  if (const std::string highlights = highlightsText(spec, capture, report); !highlights.empty())
    d.line("highlights", highlights);
  for (const std::string& warning : capture.warnings) d.line("warning", warning);
  if (report && !report->message.empty()) {
    d.line("solved", report->message);
    d.line("verdict", verdictLine(verdictOf(*report)));
    if (const std::string unseen = unseenWords(report->causes); !unseen.empty()) d.line("unseen", unseen);
  }
  d.json = {{"kind", "solved"}, {"file", file.string()}};
  d.json.update(pictureJson(spec, info));
  describeRange(file, info, d);
  d.text += "\n" + shotsText(capture);
  d.json["capture"] = jsonFromCapture(capture);
  d.json["report"] = report ? jsonFromSolveReport(*report) : Json::object();
  return d;
}

std::string rigText(const Rig& rig) {
  std::vector<std::vector<std::string>> rows{{"light", "role", "setting", ""}};
  for (const LightSetting& light : rig.lights)
    rows.push_back({light.light, roleName(light.role), settingText(light),
                    fmt::format("{}{}", light.solo ? "solo " : "", light.mute ? "mute" : "")});
  if (rig.ambient != 1) rows.push_back({"ambient", "", fmt::format("x{}", rig.ambient), ""});
  return tableText(rows);
}

Description describeSession(const fs::path& file) {
  const Session session = readSession(file);
  const Document& document = session.document;
  Description d;
  d.text = fmt::format("{}: session\n", file.string());
  d.line("set", document.source.empty() ? "none" : document.source.string());
  if (!document.colorConfig.empty()) d.line("colours", document.colorConfig.string());
  if (!document.workingSpace.empty()) d.line("working space", setColorSpaceWords(document.workingSpace));
  if (!document.display.view.empty())
    d.line("view", fmt::format("{} on {}", document.display.view, document.display.display));
  if (document.display.look)
    d.line("look of the view", document.display.look->empty() ? "none" : *document.display.look);
  if (const auto& grade = document.display.grade; grade && *grade != ColorGrade{})
    d.line("grade", grade->on ? "on" : "off");
  for (const std::string& warning : session.warnings) d.line("warning", warning);
  d.text += "\n" + rigText(document.rig);
  d.json = {{"kind", "session"}, {"file", file.string()}, {"set", document.source.string()}};
  d.json["session"] = jsonFromSession(session, {});
  d.json["warnings"] = session.warnings;
  return d;
}

Description describeRig(const fs::path& file) {
  const Rig rig = readRig(file);
  return {fmt::format("{}: rig\n\n{}", file.string(), rigText(rig)),
          {{"kind", "rig"}, {"file", file.string()}, {"rig", jsonFromRig(rig)}}};
}

Description describeImage(const fs::path& file, bool verbose) {
  ImageFileInfo info;
  const ImageSpec spec = readImageSpec(file, &info);
  Description d;
  d.text = fmt::format("{}: picture\n", file.string());
  d.line("pixels", pictureText(spec, info));
  d.line("channels", channelsText(spec));
  if (verbose)
    for (const auto& [key, value] : info.text) d.line(key, value);
  d.json = {{"kind", "image"}, {"file", file.string()}};
  d.json.update(pictureJson(spec, info));
  d.json["attributes"] = info.text;
  return d;
}

Description describeFile(const fs::path& file, bool verbose) {
  switch (sourceKind(file)) {
    case SourceKind::Session:
      return describeSession(file);
    case SourceKind::Capture: {
      const fs::path manifest = sourceFile(file);
      const Json json = readJson(manifest);
      const bool isRig = json.is_object() && json.contains("format") && json["format"] == "swaplight-rig";
      return isRig ? describeRig(manifest) : describeCapture(manifest);
    }
    case SourceKind::SolvedSet:
      return describeSolvedSet(file);
    case SourceKind::Folder:
      throw InputError("{}: a folder without a capture.json; name a file, or the folder of a capture",
                       file.string());
    case SourceKind::Other:
      break;
  }
  return describeImage(file, verbose);
}

}  // namespace

void addInfoVerb(Program& program) {
  const auto file = std::make_shared<std::string>();
  CLI::App& verb =
      program.addVerb("info", "Show what a capture, solved set, session, rig or picture contains",
                      [file](Terminal& terminal) {
                        const Description d = describeFile(*file, terminal.options().verbose);
                        terminal.result(d.text, d.json);
                        return 0;
                      });
  verb.add_option("FILE", *file, "The file, or the folder of a capture")->required();
}

}  // namespace swaplight
