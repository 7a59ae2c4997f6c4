#include "app/arguments/memory_arguments.h"

#include <linux/magic.h>
#include <sys/vfs.h>

#include "app/program/number_range.h"

namespace swaplight {
namespace {

constexpr double kGiB = double(1ULL << 30U);
// What else a solve works with takes about as much again.
constexpr double kImages = 1. / 4, kOfFiles = 1. / 4;

bool liesInMemory(const std::filesystem::path& folder) {
  struct statfs system {};
  return ::statfs(folder.empty() ? "." : folder.c_str(), &system) == 0 && system.f_type == TMPFS_MAGIC;
}

}  // namespace

void MemoryArguments::addTo(CLI::App& verb) {
  verb.add_option(
          "--memory", m_gigabytes,
          "Hold about so many GiB, and the rest of the pictures in temporary files beside the output: "
          "slower, the same result (default: all in memory)")
      ->check(NumberRange(0.001, 1e6))
      ->type_name("GIB");
}

std::unique_ptr<const ImagesInFiles> MemoryArguments::filesBeside(const std::filesystem::path& output,
                                                                  Terminal& terminal) const {
  if (m_gigabytes == 0) return nullptr;
  const std::filesystem::path folder = output.parent_path();
  if (liesInMemory(folder))
    terminal.say("warning: --memory: {} lies in memory itself: write to a disk",
                 folder.empty() ? "this folder" : folder.string());
  const double bytes = m_gigabytes * kGiB;
  return std::make_unique<const ImagesInFiles>(
      folder, ImageMemory{.all = size_t(kImages * bytes), .ofFiles = size_t(kOfFiles * bytes)});
}

}  // namespace swaplight
