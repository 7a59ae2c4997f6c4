#include "app/program/terminal.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "app/program/interrupt.h"
#include "app/program/printable.h"
#include "app/program/standard_streams.h"
#include "core/base/json.h"
#include "core/base/machine_error.h"

namespace swaplight {
namespace {

using namespace std::chrono_literals;
constexpr auto kTerminalInterval = 100ms;
constexpr auto kLogInterval = 5s;

std::string printableLines(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const size_t end = text.find('\n');
    shown += printable(text.substr(0, end));
    if (end == std::string_view::npos) break;
    shown += '\n';
    text.remove_prefix(end + 1);
  }
  return shown;
}

}  // namespace

Terminal::Terminal(CommonOptions options)
    : m_options(options),
      m_isTerminal(isatty(standardError()) != 0),
      m_lastReport(std::chrono::steady_clock::now()) {}

Terminal::~Terminal() {
  clearProgress();
}

void Terminal::result(const std::string& text, const Json& json) {
  clearProgress();
  // Names that are not UTF-8 (a file's, a header's) must not spoil the report.
  const std::string out =
      m_options.json ? json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n" : printableLines(text);
  if (std::fwrite(out.data(), 1, out.size(), stdout) != out.size() || std::fflush(stdout) != 0) {
    if (errno == EPIPE) return;  // the reader, `head` for instance, has seen enough
    throw MachineError("standard output: cannot be written: {}", std::strerror(errno));
  }
}

void Terminal::line(const std::string& text) {
  const std::lock_guard lock(m_mutex);
  clearProgress();
  sayOnStandardError(printable(text) + "\n");
}

Progress Terminal::progress() {
  Progress progress;
  progress.stop = &interrupted();
  if (!m_options.quiet)
    progress.report = [this](float fraction, std::string_view what) { report(fraction, what); };
  return progress;
}

void Terminal::report(float fraction, std::string_view what) {
  const std::lock_guard lock(m_mutex);
  const auto now = std::chrono::steady_clock::now();
  const bool first = m_isTerminal && !m_progressShown;
  if (!first && now - m_lastReport < (m_isTerminal ? kTerminalInterval : kLogInterval)) return;
  m_lastReport = now;
  m_progressShown = m_isTerminal;
  const float percent = 100 * fraction;
  if (m_isTerminal)
    sayOnStandardError(fmt::format("\r{:3.0f} %  {}\033[K", percent, printable(what)));
  else
    sayOnStandardError(fmt::format("Progress: {:.0f}% {}\n", percent, printable(what)));
}

void Terminal::clearProgress() {
  if (m_progressShown) sayOnStandardError("\r\033[K");
  m_progressShown = false;
}

void sayWarnings(const std::vector<std::string>& warnings, Terminal& terminal) {
  for (const std::string& warning : warnings) terminal.say("warning: {}", warning);
}

}  // namespace swaplight
