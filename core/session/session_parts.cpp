#include "core/session/session_parts.h"

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"

namespace swaplight {
namespace {

constexpr const char* kFolder = "folder";
constexpr int kLargestSide = 1 << 16;
constexpr int64_t kMostPixels = int64_t{1} << 28;  // no solved set of more fits into a machine of today

}  // namespace

std::string writtenPath(const std::filesystem::path& path, const std::filesystem::path& folder) {
  if (path.empty() || folder.empty()) return path.generic_string();
  return std::filesystem::absolute(path)
      .lexically_normal()
      .lexically_proximate(std::filesystem::absolute(folder).lexically_normal())
      .generic_string();
}

std::filesystem::path readPath(const std::string& text, const std::filesystem::path& folder) {
  if (text.empty()) return {};
  return std::filesystem::absolute(folder / text).lexically_normal();
}

Json jsonFromDisplay(const DisplayChoice& display) {
  Json json{{"display", display.display}, {"view", display.view}};
  if (display.look) json["look"] = *display.look;
  return json;
}

DisplayChoice displayFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  return {fields.text("display").value_or(""), fields.text("view").value_or(""), fields.text("look")};
}

Json jsonFromEdits(const EditStack& edits, const std::filesystem::path& folder) {
  Json json =
      jsonFromEditStack(withFiles(edits, [&](const std::string& file) { return writtenPath(file, folder); }));
  json["size"] = {edits.width, edits.height};
  return json;
}

EditStack editsFromJson(const Json& json, const std::filesystem::path& folder, const std::string& where) {
  JsonFields fields(json, where);
  const Json* size = fields.find("size");
  const bool known = size && size->is_array() && size->size() == 2 && (*size)[0].is_number_integer() &&
                     (*size)[1].is_number_integer();
  const int width = known ? (*size)[0].get<int>() : 0;
  const int height = known ? (*size)[1].get<int>() : 0;
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide ||
      int64_t{width} * height > kMostPixels)
    throw InputError("{}: \"size\" is {}, expected [width, height] of the picture", where,
                     size ? size->dump() : "missing");
  return withFiles(editStackFromJson(json, width, height, where),
                   [&](const std::string& file) { return readPath(file, folder).string(); });
}

Json jsonFromCameraLook(const FilterPipeline& look, const std::filesystem::path& folder) {
  Json json = jsonFromPipeline(look);
  if (look.name.empty()) json["name"] = kCameraLookKey;
  if (!look.folder.empty()) json[kFolder] = writtenPath(look.folder, folder);
  return json;
}

FilterPipeline cameraLookFromJson(Json json, const std::filesystem::path& folder, const std::string& where) {
  const std::string files = JsonFields(json, where).text(kFolder).value_or("");
  json.erase(kFolder);
  FilterPipeline look = pipelineFromJson(json, where);
  look.folder = readPath(files, folder);
  if (!look.folder.has_filename()) look.folder = look.folder.parent_path();  // "FOLDER/." is "FOLDER/"
  return look;
}

}  // namespace swaplight
