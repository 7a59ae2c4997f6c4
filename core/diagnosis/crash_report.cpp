#include "core/diagnosis/crash_report.h"

#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <map>
#include <mutex>
#include <string>

#include "core/base/version.h"
#include "core/file/temporary_names.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

#ifdef SWAPLIGHT_SANITIZE
constexpr bool kSanitizerReports = true;  // it says more than we can
#else
constexpr bool kSanitizerReports = false;
#endif
constexpr size_t kMostText = 8192;
constexpr int kMostFrames = 128;
constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// What the handler needs is ready before it runs: in there nothing may be allocated (signal-safety(7)).
std::array<char, 4096> g_file{};
std::array<char, kMostText> g_facts{};
std::array<char, 512> g_exception{};
int g_words = STDERR_FILENO;

const char* nameOf(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "SIGSEGV (a wrong address)";
    case SIGBUS:
      return "SIGBUS (a wrong address, or a file that was cut)";
    case SIGFPE:
      return "SIGFPE (a division of whole numbers by 0)";
    case SIGILL:
      return "SIGILL (an instruction that this processor lacks)";
    default:
      return "SIGABRT (the program gave up)";
  }
}

void copyText(std::string_view text, char* to, size_t room) {
  const size_t count = std::min(text.size(), room - 1);
  std::memcpy(to, text.data(), count);
  to[count] = 0;
}

void say(int file, const char* words) {
  if (::write(file, words, std::strlen(words)) < 0) return;  // nobody is there to be told
}

void sayHex(int file, uintptr_t value) {
  std::array<char, 2 * sizeof value + 1> digits{};
  for (size_t i = digits.size() - 1; i-- > 0; value >>= 4) digits[i] = "0123456789abcdef"[value & 15];
  say(file, digits.data());
}

void writeReport(int file, int signal, const siginfo_t* info) {
  say(file, "Swaplight ");
  say(file, version());
  say(file, " ended by ");
  say(file, nameOf(signal));
  say(file, " at ");
  sayHex(file, reinterpret_cast<uintptr_t>(info->si_addr));
  say(file, "\n");
  if (g_exception[0] != 0) say(file, "exception: "), say(file, g_exception.data()), say(file, "\n");
  say(file, g_facts.data());
  say(file, "\nwhere (addr2line -Cfe FILE ADDRESS tells lines):\n");
  std::array<void*, kMostFrames> frames{};
  const int count = ::backtrace(frames.data(), kMostFrames);
  ::backtrace_symbols_fd(frames.data(), count, file);
}

void onCrash(int signal, siginfo_t* info, void* /*context*/) {
  static std::atomic_flag begun = ATOMIC_FLAG_INIT;
  if (begun.test_and_set()) {
    while (true) ::pause();  // another thread is at it
  }
  removeTemporaryFiles();
  const int file = ::open(g_file.data(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, 0600);
  if (file >= 0) writeReport(file, signal, info);
  say(g_words, "swaplight: crashed. ");
  say(g_words, file >= 0 ? "What its makers want to know stands in " : "No report could be written to ");
  say(g_words, g_file.data());
  say(g_words, "\n");
  ::signal(signal, SIG_DFL);  // SA_RESETHAND is not for SIGABRT's second round
  ::raise(signal);
}

[[noreturn]] void onTerminate() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::exception& error) {
    copyText(error.what(), g_exception.data(), g_exception.size());
  } catch (...) {
    copyText("of an unknown kind", g_exception.data(), g_exception.size());
  }
  std::abort();
}

std::string nowText() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y%m%d-%H%M%S", &local);
  return text.data();
}

}  // namespace

void reportCrashes(const fs::path& folder, int words) {
  if (kSanitizerReports) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || ::access(folder.c_str(), W_OK) != 0) return;
  const fs::path file = folder / ("crash-" + nowText() + "-" + std::to_string(::getpid()) + ".txt");
  copyText(file.native(), g_file.data(), g_file.size());
  g_words = words;
  std::array<void*, 1> once{};
  ::backtrace(once.data(), 1);  // loads what it needs: in the handler that would allocate
  static std::array<char, size_t{1} << 16> stack;
  const stack_t own{stack.data(), 0, stack.size()};
  ::sigaltstack(&own, nullptr);  // for a stack that is full
  struct sigaction action {};
  action.sa_sigaction = onCrash;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
  for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
  std::set_terminate(onTerminate);
}

void setCrashFact(std::string_view name, std::string_view value) {
  static std::mutex mutex;
  static std::map<std::string, std::string> facts;
  const std::lock_guard lock(mutex);
  facts[std::string(name)] = value;
  std::string text;
  for (const auto& [key, said] : facts) text += key + ": " + said + "\n";
  copyText(text, g_facts.data(), g_facts.size());
}

std::optional<fs::path> unseenCrash(const fs::path& folder) {
  const fs::path mark = folder / "seen";
  std::error_code error;
  const auto seen = fs::last_write_time(mark, error);
  const bool first = static_cast<bool>(error);
  std::optional<fs::path> newest;
  fs::file_time_type newestTime{};
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const auto time = entry->last_write_time(error);
    const bool report = entry->path().filename().string().starts_with("crash-");
    if (error || !report || (!first && time <= seen) || (newest && time <= newestTime)) continue;
    newest = entry->path();
    newestTime = time;
  }
  if (!newest) return newest;
  const int file = ::open(mark.c_str(), O_CREAT | O_WRONLY | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (file >= 0) ::close(file);
  fs::last_write_time(mark, newestTime, error);
  return newest;
}

}  // namespace swaplight
