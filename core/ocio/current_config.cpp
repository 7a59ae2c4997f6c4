#include <atomic>
#include <cstdlib>
#include <map>
#include <mutex>

#include "core/base/error.h"
#include "core/ocio/color_config.h"

namespace swaplight {
namespace {

/// Every configuration that this process has used, by its file: they are few, and references to them stay
/// valid.
struct Configs {
  std::mutex mutex;
  std::map<std::string, std::unique_ptr<ColorConfig>> byFile;
  std::atomic<const ColorConfig*> current = nullptr;
  std::atomic<bool> environmentIgnored = false;

  const ColorConfig& load(const std::string& file) {
    std::unique_ptr<ColorConfig>& config = byFile[file];
    if (!config) config = std::make_unique<ColorConfig>(file);
    return *config;
  }
};

Configs& configs() {
  static Configs all;
  return all;
}

std::string environmentFile() {
  const char* file = std::getenv("OCIO");  // NOLINT(concurrency-mt-unsafe)
  return file && !configs().environmentIgnored ? file : "";
}

}  // namespace

const ColorConfig& ColorConfig::current() {
  if (const ColorConfig* config = configs().current) return *config;
  const std::lock_guard lock(configs().mutex);
  const std::string file = environmentFile();
  try {
    configs().current = &configs().load(file);
  } catch (const InputError& error) {
    throw InputError("{} Name another file in $OCIO, or unset it to use the built-in configuration.",
                     error.what());
  }
  return *configs().current;
}

void ColorConfig::choose(const std::filesystem::path& file) {
  if (fromEnvironment()) return;
  const std::lock_guard lock(configs().mutex);
  try {
    configs().current = &configs().load(file.string());
  } catch (const InputError& error) {
    throw InputError(
        "{} Correct \"color_config\" in the session, or set $OCIO to a configuration that works.",
        error.what());
  }
}

bool ColorConfig::fromEnvironment() {
  return !environmentFile().empty();
}

std::string ColorConfig::fallBack() {
  try {
    const ColorConfig& config = current();
    config.checkView({});
    return {};
  } catch (const InputError& error) {
    const std::lock_guard lock(configs().mutex);
    configs().environmentIgnored = true;
    configs().current = &configs().load("");
    return error.what();
  }
}

}  // namespace swaplight
