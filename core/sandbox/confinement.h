#pragma once

#include <cstddef>

namespace swaplight {

/// What a process that reads strangers' files may still do.
struct Confinement {
  size_t memoryBytes = 0;  ///< of address space beyond what it has now
  int processorSeconds = 0;
};

/// Gives up, for good, everything but reading files, computing and answering on `answers`: no writing, no new
/// files, no network, no other processes or programs, bounded memory and time. Limits hold everywhere, the
/// filter of system calls where the kernel has one (Linux, by libseccomp). Call it while the process has one
/// thread. False where the filter could not be set: the limits hold then.
bool confine(const Confinement& confinement, int answers);

/// Whether this program and this kernel can filter system calls, in words for a report.
[[nodiscard]] const char* confinementWords();

}  // namespace swaplight
