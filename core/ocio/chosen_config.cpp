#include "core/ocio/chosen_config.h"

#include <cstdlib>

#include "core/base/error.h"

namespace swaplight {
namespace {

/// `advice`: what to do where the file cannot be used.
std::shared_ptr<const ColorConfig> read(const std::string& file, const char* advice) {
  try {
    return std::make_shared<const ColorConfig>(file);
  } catch (const InputError& error) {
    throw InputError("{} {}", error.what(), advice);
  }
}

}  // namespace

std::shared_ptr<const ColorConfig> environmentConfig() {
  const char* file = std::getenv("OCIO");  // NOLINT(concurrency-mt-unsafe)
  if (!file || *file == '\0') return nullptr;
  return read(file, "Name another file in $OCIO, or unset it to use the built-in configuration.");
}

std::shared_ptr<const ColorConfig> sessionConfig(const std::filesystem::path& file) {
  return read(file.string(),
              "Correct \"color_config\" in the session, or set $OCIO to a configuration that works.");
}

std::shared_ptr<const ColorConfig> programConfig(const std::filesystem::path& sessionFile) {
  std::shared_ptr<const ColorConfig> config = environmentConfig();
  return config ? config : sessionConfig(sessionFile);
}

}  // namespace swaplight
