#include "app/program/interrupt.h"

#include <csignal>

namespace swaplight {
namespace {

std::atomic<bool> g_interrupted{false};
std::atomic<int> g_signal{SIGINT};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void onSignal(int signal) {
  g_signal = signal;
  g_interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catchInterrupts() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

const std::atomic<bool>& interrupted() {
  return g_interrupted;
}

int interruptExitCode() {
  return 128 + g_signal;
}

}  // namespace swaplight
