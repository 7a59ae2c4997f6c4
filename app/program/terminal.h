#pragma once

#include <fmt/core.h>

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/base/progress.h"

namespace swaplight {

/// The options that every verb has.
struct CommonOptions {
  bool json = false;     ///< one JSON object on standard output, and nothing else there
  bool quiet = false;    ///< only errors on standard error
  bool verbose = false;  ///< more on standard error
  int threads = 0;       ///< 0: one a core
};

/// Where a verb's words go. Results go to standard output, everything else to standard error.
class Terminal {
 public:
  explicit Terminal(CommonOptions options);
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal();

  [[nodiscard]] const CommonOptions& options() const { return m_options; }

  /// The verb's result: `json` with --json, `text` without. Called once, at the end.
  void result(const std::string& text, const Json& json);

  /// A line on standard error, unless -q.
  template <typename... Args>
  void say(fmt::format_string<Args...> format, Args&&... args) {
    if (!m_options.quiet) line(fmt::format(format, std::forward<Args>(args)...));
  }
  /// An error that does not end the verb: a line on standard error, with -q as well.
  template <typename... Args>
  void complain(fmt::format_string<Args...> format, Args&&... args) {
    line(fmt::format(format, std::forward<Args>(args)...));
  }
  /// As say(), only with -v.
  template <typename... Args>
  void detail(fmt::format_string<Args...> format, Args&&... args) {
    if (m_options.verbose) line(fmt::format(format, std::forward<Args>(args)...));
  }

  /// Shows how far work has come (a line that overwrites itself on a terminal, a line now and then
  /// elsewhere), and stops it on Ctrl-C. Valid as long as the Terminal.
  [[nodiscard]] Progress progress();

 private:
  void line(const std::string& text);
  void report(float fraction, std::string_view what);
  void clearProgress();

  CommonOptions m_options;
  bool m_isTerminal;
  std::mutex m_mutex;
  bool m_progressShown = false;
  std::chrono::steady_clock::time_point m_lastReport;
};

/// What a reader has found worth saying.
void sayWarnings(const std::vector<std::string>& warnings, Terminal& terminal);

}  // namespace swaplight
