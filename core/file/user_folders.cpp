#include "core/file/user_folders.h"

#include <cstdlib>

namespace swaplight {
namespace {

// The specification asks to ignore relative paths in its variables.
std::filesystem::path fromEnvironment(const char* variable, const char* fallback) {
  const char* value = std::getenv(variable);
  if (value && std::filesystem::path(value).is_absolute()) return std::filesystem::path(value) / "swaplight";
  return homeFolder() / fallback / "swaplight";
}

}  // namespace

std::filesystem::path homeFolder() {
  const char* home = std::getenv("HOME");
  return home && *home ? std::filesystem::path(home) : std::filesystem::path("/");
}

std::filesystem::path configFolder() {
  return fromEnvironment("XDG_CONFIG_HOME", ".config");
}

std::filesystem::path dataFolder() {
  return fromEnvironment("XDG_DATA_HOME", ".local/share");
}

std::filesystem::path stateFolder() {
  return fromEnvironment("XDG_STATE_HOME", ".local/state");
}

}  // namespace swaplight
