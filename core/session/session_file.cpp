#include "core/session/session_file.h"

#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/cue/cue_list.h"
#include "core/edit/mask/selection.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"
#include "core/session/gallery_json.h"
#include "core/session/known_files.h"
#include "core/session/session_parts.h"
#include "core/session/unknown_keys.h"
#include "core/set/set_color_space.h"

namespace swaplight {
namespace {

constexpr const char* kFormat = "swaplight-session";

/// One of a newer version is kept, unread: a picture without it is better than no session.
void readCameraLook(JsonFields& fields, const std::filesystem::path& folder, Session& session) {
  const Json* look = fields.find(kCameraLookKey);
  if (!look) return;
  const std::string where = fields.where() + ": " + kCameraLookKey;
  if (JsonFields(*look, where).number("version", 1, 1e6).value_or(kPipelineVersion) > kPipelineVersion)
    session.warnings.push_back(
        where + " is of a newer Swaplight: it is kept when you save, but pictures are shown without it.");
  else
    session.document.cameraLook = cameraLookFromJson(*look, folder, where);
}

/// Cues keep their look's name: another program may have taken the look away.
void sayMissingLooks(Session& session, const std::string& name) {
  for (const Cue& cue : session.document.cues)
    if (!findSavedLook(session.document.looks, cue.look))
      session.warnings.push_back(fmt::format("{}: cue {}: the gallery has no look \"{}\"", name,
                                             cueNumberText(cue.number), cue.look));
}

std::string workingSpaceFrom(JsonFields& fields) {
  std::string space = fields.text("working_space").value_or("");
  try {
    checkSetColorSpace(space);
  } catch (const InputError& error) {
    throw InputError("{}: working_space: {}", fields.where(), error.what());
  }
  return space;
}

std::vector<std::string> topLevelNames(const Json& unknown) {
  std::vector<std::string> names;
  for (const auto& [key, value] : unknown.items())
    if (key != "animation") names.push_back(key);  // kept as it is: see rig_animation.h
  return names;
}

}  // namespace

Json jsonFromSession(const Session& session, const std::filesystem::path& folder) {
  const Document& document = session.document;
  Json json;
  json["format"] = kFormat;
  json["version"] = session.version;
  json["source"] = writtenPath(document.source, folder);
  json["solve"] = jsonFromSolveOptions(document.solve);
  json["rig"] = jsonFromRig(document.rig);
  if (document.edits != EditStack{}) json["edits"] = jsonFromEdits(document.edits, folder);
  if (!document.colorConfig.empty()) json["color_config"] = writtenPath(document.colorConfig, folder);
  if (!document.workingSpace.empty()) json["working_space"] = document.workingSpace;
  if (!document.selection.empty()) json["selection"] = jsonFromMask(document.selection);
  json["display"] = jsonFromDisplay(document.display);
  if (!document.cameraLook.stages.empty())
    json[kCameraLookKey] = jsonFromCameraLook(document.cameraLook, folder);
  if (!document.looks.empty()) json["looks"] = jsonFromGallery(document.looks, folder);
  if (!document.cues.empty()) json["cues"] = jsonFromCues(document.cues);
  if (!session.studio.empty()) json["studio"] = session.studio.json();
  keepUnknownKeys(json, session.unknown.json());
  return json;
}

Session sessionFromJson(const Json& json, const std::filesystem::path& folder, const std::string& name) {
  JsonFields fields(json, name);
  if (fields.text("format").value_or("") != kFormat)
    throw InputError("{}: not a session: its \"format\" is not \"{}\"", name, kFormat);
  Session session;
  session.version = static_cast<int>(fields.number("version", 1, 1e6).value_or(kSessionVersion));
  session.document.source = readPath(fields.text("source").value_or(""), folder);
  if (const Json* solve = fields.find("solve"))
    session.document.solve = solveOptionsFromJson(*solve, name + ": solve");
  if (const Json* edits = fields.find("edits"))
    session.document.edits = editsFromJson(*edits, folder, name + ": edits");
  if (const Json* selection = fields.find("selection"))
    session.document.selection =
        selectionOf(maskFromJson(*selection, 1, 1, name + ": selection", &session.warnings));
  if (const Json* rig = fields.find("rig")) session.document.rig = rigFromJson(*rig, name + ": rig");
  session.document.colorConfig = readPath(fields.text("color_config").value_or(""), folder);
  session.document.workingSpace = workingSpaceFrom(fields);
  if (const Json* display = fields.find("display"))
    session.document.display = displayFromJson(*display, name + ": display");
  readCameraLook(fields, folder, session);
  if (const Json* looks = fields.find("looks"))
    session.document.looks = galleryFromJson(*looks, folder, session.document.edits, name + ": look");
  if (const Json* cues = fields.find("cues")) session.document.cues = cuesFromJson(*cues, name + ": cue");
  sayMissingLooks(session, name);
  if (const Json* studio = fields.find("studio")) session.studio = *studio;

  session.unknown = unknownKeys(json, jsonFromSession(session, folder));
  const std::vector<std::string> strangers = topLevelNames(session.unknown.json());
  if (session.version > kSessionVersion)
    session.warnings.push_back(fmt::format(
        "{}: written by a newer Swaplight (version {}, this one knows {}). What this one does not "
        "understand is kept when you save.",
        name, session.version, kSessionVersion));
  else if (!strangers.empty())
    session.warnings.push_back(
        fmt::format("{}: unknown keys are kept: {}", name, fmt::join(strangers, ", ")));
  return session;
}

Session readSession(const std::filesystem::path& file) {
  rememberFile(file);  // first: what changes while it is read has changed
  return sessionFromJson(readJson(file), std::filesystem::absolute(file).parent_path(), file.string());
}

void writeSession(const Session& session, const std::filesystem::path& file) {
  checkUnchanged(file);
  writeJson(jsonFromSession(session, std::filesystem::absolute(file).parent_path()), file);
  rememberFile(file);
}

bool isSessionFile(const std::filesystem::path& file) {
  return lowerExtension(file) == ".swaplight";
}

}  // namespace swaplight
