#include "core/session/session_parts.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/json_integer.h"
#include "core/file/json_fields.h"
#include "core/ocio/grade_file.h"

namespace swaplight {
namespace {

constexpr const char* kFolder = "folder";
constexpr const char* kGrade = "grade";
constexpr int kLargestSide = 1 << 16;
constexpr int64_t kMostPixels = int64_t{1} << 28;  // no solved set of more fits into a machine of today

/// Three numbers, or what there was where the key is missing.
void readTriple(JsonFields& fields, const std::string& key, std::array<double, 3>& values) {
  const Json* found = fields.find(key);
  if (!found) return;
  const bool three = found->is_array() && found->size() == 3 &&
                     std::all_of(found->begin(), found->end(), [](const Json& v) { return v.is_number(); });
  if (!three)
    throw InputError("{}: \"{}\" is {}, expected three numbers: R, G, B", fields.where(), key,
                     describeJson(*found));
  for (size_t c = 0; c < 3; ++c) values[c] = (*found)[c].get<double>();
}

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

Json jsonFromGrade(const ColorGrade& grade) {
  return {{"on", grade.on},
          {"slope", grade.slope},
          {"offset", grade.offset},
          {"power", grade.power},
          {"saturation", grade.saturation}};
}

ColorGrade gradeFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  ColorGrade grade;
  grade.on = fields.boolean("on").value_or(true);
  readTriple(fields, "slope", grade.slope);
  readTriple(fields, "offset", grade.offset);
  readTriple(fields, "power", grade.power);
  grade.saturation = fields.number("saturation", 0, kMostGrade).value_or(1);
  checkGrade(grade, where);
  return grade;
}

Json jsonFromDisplay(const DisplayChoice& display) {
  Json json{{"display", display.display}, {"view", display.view}};
  if (display.look) json["look"] = *display.look;
  if (display.grade && *display.grade != ColorGrade{}) json[kGrade] = jsonFromGrade(*display.grade);
  return json;
}

DisplayChoice displayFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  DisplayChoice display{fields.text("display").value_or(""), fields.text("view").value_or(""),
                        fields.text("look")};
  if (const Json* grade = fields.find(kGrade)) display.grade = gradeFromJson(*grade, where + ": grade");
  return display;
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
  const bool two = size && size->is_array() && size->size() == 2;
  const int width = two ? integerOf((*size)[0]).value_or(0) : 0;
  const int height = two ? integerOf((*size)[1]).value_or(0) : 0;
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
