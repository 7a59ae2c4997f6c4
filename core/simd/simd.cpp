#include "core/simd/simd.h"

namespace swaplight {

int processorLevel() {
#if defined(__x86_64__)
  static const int level = [] {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      return 4;
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")
               ? 3
               : 1;
  }();
  return level;
#else
  return 1;
#endif
}

}  // namespace swaplight
