#include "core/session/known_files.h"

#include <sys/stat.h>

#include <map>
#include <mutex>
#include <optional>

#include "core/base/error.h"

namespace swaplight {
namespace {

/// A file is replaced by another inode when we save it, and changed in place by some editors.
struct Stamp {
  ino_t inode = 0;
  off_t size = 0;
  time_t seconds = 0;
  long nanoseconds = 0;
  bool operator==(const Stamp&) const = default;
};

std::optional<Stamp> stampOf(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return Stamp{status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

std::filesystem::path keyOf(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).lexically_normal();
}

struct Known {
  std::mutex mutex;
  std::map<std::filesystem::path, Stamp> stamps;
};

Known& known() {
  static Known files;
  return files;
}

}  // namespace

void rememberFile(const std::filesystem::path& file) {
  const std::lock_guard lock(known().mutex);
  if (const std::optional<Stamp> stamp = stampOf(file))
    known().stamps[keyOf(file)] = *stamp;
  else
    known().stamps.erase(keyOf(file));
}

void checkUnchanged(const std::filesystem::path& file) {
  {
    const std::lock_guard lock(known().mutex);
    const auto before = known().stamps.find(keyOf(file));
    const std::optional<Stamp> now = stampOf(file);
    if (before == known().stamps.end() || !now || before->second == *now) return;
  }
  rememberFile(file);
  throw InputError(
      "{}: was changed by another program since it was opened here, so that it is not replaced. Save under "
      "another name, or save again to replace it.",
      file.string());
}

}  // namespace swaplight
