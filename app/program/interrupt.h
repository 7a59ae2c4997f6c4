#pragma once

#include <atomic>

namespace swaplight {

/// Makes Ctrl-C (SIGINT) and SIGTERM ask the work to stop, so that it can clean up. A second one ends the
/// process at once.
void catchInterrupts();

/// True once one has come; what Progress::stop points at.
[[nodiscard]] const std::atomic<bool>& interrupted();

/// The exit code of a process ended by the signal that came: 130 for Ctrl-C.
[[nodiscard]] int interruptExitCode();

}  // namespace swaplight
