#include "core/filter/favourite_looks.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"
#include "core/file/user_folders.h"
#include "core/filter/filter_library.h"

namespace swaplight {
namespace {

constexpr const char* kFavouritesFormat = "swaplight-favourite-looks";
constexpr int kFavouritesVersion = 1;
constexpr size_t kMostFavourites = 1000;

}  // namespace

std::vector<std::string> sceneTypes() {
  return {"Snow",  "Indoor",     "Twilight", "Beach",    "Fireworks",
          "Night", "Magic hour", "Overcast", "Tungsten", "Noir"};
}

std::filesystem::path favouriteLooksFile() {
  return dataFolder() / "favourite-looks.json";
}

std::vector<std::string> readFavouriteLooks(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return sceneTypes();
  const Json json = readJson(file);
  JsonFields fields(json, file.string());
  if (fields.text("format").value_or("") != kFavouritesFormat)
    throw InputError("{}: expected \"format\": \"{}\"; remove the file to begin anew", file.string(),
                     kFavouritesFormat);
  if (fields.number("version", 1, 1e6).value_or(kFavouritesVersion) > kFavouritesVersion)
    throw InputError("{}: was written by a newer version of swaplight; update this one", file.string());
  std::vector<std::string> names;
  for (const Json& name : fields.list("camera_looks", "a list of camera looks' names", kMostFavourites)) {
    if (!name.is_string())
      throw InputError("{}: \"camera_looks\" holds {}, expected names of camera looks", file.string(),
                       describeJson(name));
    if (!isFavourite(names, name.get<std::string>())) names.push_back(name.get<std::string>());
  }
  return names;
}

void writeFavouriteLooks(const std::vector<std::string>& names, const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);  // writing says what is wrong
  writeJson(Json{{"format", kFavouritesFormat}, {"version", kFavouritesVersion}, {"camera_looks", names}},
            file);
}

bool isFavourite(const std::vector<std::string>& names, const std::string& name) {
  const std::string key = filterKey(name);
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& other) { return filterKey(other) == key; });
}

std::vector<std::string> withFavourite(std::vector<std::string> names, const std::string& name) {
  if (!isFavourite(names, name)) names.insert(names.begin(), name);
  return names;
}

std::vector<std::string> withoutFavourite(std::vector<std::string> names, const std::string& name) {
  std::erase_if(names, [key = filterKey(name)](const std::string& other) { return filterKey(other) == key; });
  return names;
}

}  // namespace swaplight
