#pragma once

#include <atomic>

namespace swaplight {

/// Makes Ctrl-C (SIGINT), SIGTERM and a terminal that closes (SIGHUP, where it is not ignored) ask the work
/// to stop, so that it can clean up. Work that has not come to a place where it can stop within 0.8 s, or a
/// second signal, ends the process then and there: temporary files are removed, and no file is ever left half
/// written (core/file/atomic_file.h).
void catchInterrupts();

/// True once one has come; what Progress::stop points at.
[[nodiscard]] const std::atomic<bool>& interrupted();

/// The work has stopped by itself. The exit code of a process ended by the signal that came: 130 for Ctrl-C.
[[nodiscard]] int interruptExitCode();

}  // namespace swaplight
