#include "core/edit/stack/edit_file.h"

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/json_integer.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFormat = "swaplight-edits";
constexpr int kVersion = 1;

}  // namespace

EditStack readEdits(const fs::path& file, int width, int height, std::vector<std::string>* warnings) {
  const Json json = readJson(file);
  const std::string name = file.string();
  if (!json.is_object() || json.value("format", Json()) != Json(kFormat))
    throw InputError("{}: is no file of edits: its \"format\" is not \"{}\".", name, kFormat);
  const Json version = json.value("version", Json());
  const int number = integerOf(version).value_or(0);
  if (number < 1 || number > kVersion)
    throw InputError("{}: has version {}, and this program reads versions up to {}.", name, version.dump(),
                     kVersion);

  const fs::path folder = fs::absolute(file).parent_path();
  return withFiles(editStackFromJson(json, width, height, name, warnings), [&](const std::string& path) {
    return fs::path(path).is_relative() ? (folder / path).lexically_normal().string() : path;
  });
}

void writeEdits(const EditStack& stack, const fs::path& file) {
  Json json = {{"format", kFormat}, {"version", kVersion}};
  json.update(jsonFromEditStack(stack));
  writeJson(json, file);
}

}  // namespace swaplight
