#include "app/program/interrupt.h"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "app/program/standard_streams.h"
#include "core/file/temporary_names.h"

namespace swaplight {
namespace {

constexpr suseconds_t kPatience = 800'000;  // microseconds

std::atomic<bool> g_interrupted{false};
std::atomic<int> g_signal{SIGINT};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

// All of these run within a signal handler: only what is allowed there (signal-safety(7)).

void endNow(int) {
  removeTemporaryFiles();
  constexpr std::string_view kWords = "swaplight: stopped\n";
  if (::write(standardError(), kWords.data(), kWords.size()) < 0) {
    // Nobody is there to be told.
  }
  ::_exit(128 + g_signal);
}

void setTimer(suseconds_t microseconds) {
  const itimerval time{{0, 0}, {0, microseconds}};
  ::setitimer(ITIMER_REAL, &time, nullptr);
}

void onSignal(int signal) {
  if (g_interrupted) endNow(signal);
  g_signal = signal;
  g_interrupted = true;
  setTimer(kPatience);
}

// No SA_RESTART: a read that waits for somebody else is to end.
void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void catchInterrupts() {
  handle(SIGALRM, endNow);
  handle(SIGINT, onSignal);
  handle(SIGTERM, onSignal);
  // A terminal that is closed; whoever was started by nohup goes on.
  struct sigaction hangUp {};
  if (::sigaction(SIGHUP, nullptr, &hangUp) == 0 && hangUp.sa_handler != SIG_IGN) handle(SIGHUP, onSignal);
}

const std::atomic<bool>& interrupted() {
  return g_interrupted;
}

int interruptExitCode() {
  setTimer(0);
  return 128 + g_signal;
}

}  // namespace swaplight
