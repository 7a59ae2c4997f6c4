#include "core/simd/simd.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <string_view>

#include "core/base/error.h"

namespace swaplight {
namespace {

int levelOf(std::string_view name) {
  if (name == "1" || name == "3" || name == "4") return name.front() - '0';
  throw InputError(
      "SWAPLIGHT_PROCESSOR_LEVEL is '{}': give 1, 3 or 4 (as in x86-64-v3), or leave it unset to use what "
      "this processor has",
      name);
}

int levelAtStart() {
  const char* asked = std::getenv("SWAPLIGHT_PROCESSOR_LEVEL");  // NOLINT(concurrency-mt-unsafe): once
  return asked ? std::min(levelOf(asked), machineLevel()) : machineLevel();
}

std::atomic<int>& level() {
  static std::atomic<int> value = levelAtStart();
  return value;
}

}  // namespace

int machineLevel() {
// clang 14 (which checks this code, but does not build it for anyone) cannot ask for a level.
#if defined(__x86_64__) && !defined(__clang__)
  if (__builtin_cpu_supports("x86-64-v4")) return 4;
  return __builtin_cpu_supports("x86-64-v3") ? 3 : 1;
#else
  return 1;
#endif
}

int processorLevel() {
  return level().load(std::memory_order_relaxed);
}

void setProcessorLevel(int wanted) {
  level() = std::min(wanted, machineLevel());
}

}  // namespace swaplight
