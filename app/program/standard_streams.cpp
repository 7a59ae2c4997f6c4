#include "app/program/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

namespace swaplight {
namespace {

int g_standardError = STDERR_FILENO;

}  // namespace

void openStandardStreams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free number is taken, which is this one.
    if (::open("/dev/null", O_RDONLY) != stream) std::abort();
  }
}

void ignoreWriteSignals() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

void silenceLibraries() {
#ifndef SWAPLIGHT_SANITIZE  // its reports go there, too
  const int ours = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (ours >= 0 && nowhere >= 0 && ::dup2(nowhere, STDERR_FILENO) >= 0) g_standardError = ours;
  if (nowhere >= 0) ::close(nowhere);
#endif
}

int standardError() {
  return g_standardError;
}

void sayOnStandardError(std::string_view words) noexcept {
  while (!words.empty()) {
    const ssize_t written = ::write(g_standardError, words.data(), words.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    words.remove_prefix(static_cast<size_t>(written));
  }
}

}  // namespace swaplight
