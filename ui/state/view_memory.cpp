#include "ui/state/view_memory.h"

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/ocio/color_config.h"
#include "core/ocio/tone_curve.h"
#include "core/session/session_parts.h"

namespace swaplight {
namespace {

constexpr const char* kBuiltin = "built-in";

/// By the configuration's name; an object, empty where there is none that can be read.
Json remembered(const std::filesystem::path& file) {
  try {
    if (!std::filesystem::exists(file)) return Json::object();
    Json json = readJson(file);
    return json.is_object() ? json : Json::object();
  } catch (const std::exception&) {
    return Json::object();
  }
}

bool usable(const ColorConfig& config, const DisplayChoice& choice) {
  try {
    config.checkView(choice);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::filesystem::path viewMemoryFile(const std::filesystem::path& stateFolder) {
  return stateFolder / "view.json";
}

DisplayChoice openingView(const ColorConfig& config, const std::filesystem::path& file) {
  const Json all = remembered(file);
  if (const auto found = all.find(config.name()); found != all.end()) {
    try {
      const DisplayChoice choice = displayFromJson(*found, file.string()).withoutGrade();
      if (usable(config, choice)) return choice;
    } catch (const InputError&) {  // written by hand: as if there were none
    }
  }
  if (config.name() != kBuiltin) return {};
  return {config.defaultDisplay(), kRolledOffView};
}

void rememberView(const ColorConfig& config, const DisplayChoice& choice, const std::filesystem::path& file) {
  if (file.empty()) return;
  Json all = remembered(file);
  all[config.name()] = jsonFromDisplay(choice.withoutGrade());
  try {
    std::filesystem::create_directories(file.parent_path());
    writeJson(all, file);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace swaplight
