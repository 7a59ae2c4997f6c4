#include "core/diagnosis/program_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <ctime>
#include <string>
#include <system_error>

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr uintmax_t kLargest = 1 << 20;  // bytes
constexpr size_t kLongestLine = 4000;    // bytes

std::atomic<int> g_log{-1};

void rotate(const fs::path& folder) {
  std::error_code error;
  const uintmax_t size = fs::file_size(folder / "swaplight.log", error);
  if (error || size < kLargest) return;
  fs::rename(folder / "swaplight.1.log", folder / "swaplight.2.log", error);
  fs::rename(folder / "swaplight.log", folder / "swaplight.1.log", error);
}

}  // namespace

void openProgramLog(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  rotate(folder);
  constexpr int kHow = O_CREAT | O_APPEND | O_WRONLY | O_NOFOLLOW | O_CLOEXEC;
  const int old = g_log.exchange(::open((folder / "swaplight.log").c_str(), kHow, 0600));
  if (old >= 0) ::close(old);
}

void logLine(std::string_view words) noexcept try {
  const int log = g_log;
  if (log < 0) return;
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 32> time{};
  std::strftime(time.data(), time.size(), "%Y-%m-%d %H:%M:%S", &local);
  std::string line = std::string(time.data()) + " " + std::to_string(::getpid()) + " ";
  line += words.substr(0, kLongestLine);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
      ' ');
  line += '\n';
  if (::write(log, line.data(), line.size()) < 0) return;  // a full disk has nothing to do with the work
} catch (...) {  // NOLINT(bugprone-empty-catch): no memory for a line
}

}  // namespace swaplight
