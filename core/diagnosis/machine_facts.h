#pragma once

#include <string>

namespace swaplight {

/// "Debian GNU/Linux 12 (bookworm), Linux 6.1.0".
[[nodiscard]] std::string systemWords();
/// "AMD EPYC 9454, 16 threads".
[[nodiscard]] std::string processorWords();

struct MachineMemory {
  double gigabytes = 0;
  double availableGigabytes = 0;
};
[[nodiscard]] MachineMemory machineMemory();

}  // namespace swaplight
