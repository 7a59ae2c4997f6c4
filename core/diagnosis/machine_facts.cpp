#include "core/diagnosis/machine_facts.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <thread>

namespace swaplight {
namespace {

/// What stands behind a key at the beginning of a line; empty where there is none.
std::string valueIn(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const std::string value = line.substr(line.find_first_of("=:") + 1);
    const size_t first = value.find_first_not_of(" \t\""), last = value.find_last_not_of(" \t\"");
    return first == std::string::npos ? "" : value.substr(first, last - first + 1);
  }
  return {};
}

}  // namespace

std::string systemWords() {
  utsname names{};
  ::uname(&names);
  const std::string distribution = valueIn("/etc/os-release", "PRETTY_NAME");
  return (distribution.empty() ? "" : distribution + ", ") + names.sysname + " " + names.release;
}

std::string processorWords() {
  const std::string name = valueIn("/proc/cpuinfo", "model name");
  return (name.empty() ? "" : name + ", ") + std::to_string(std::thread::hardware_concurrency()) + " threads";
}

MachineMemory machineMemory() {
  const auto page = static_cast<double>(::sysconf(_SC_PAGESIZE));
  MachineMemory memory{1e-9 * page * static_cast<double>(::sysconf(_SC_PHYS_PAGES)), 0};
  const std::string available = valueIn("/proc/meminfo", "MemAvailable");
  memory.availableGigabytes = available.empty() ? memory.gigabytes : 1.024e-6 * std::stod(available);
  return memory;
}

}  // namespace swaplight
