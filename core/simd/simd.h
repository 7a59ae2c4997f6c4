#pragma once

/// Loops that the compiler should vectorise, compiled once for each class of x86-64 processor (v4: AVX-512,
/// v3: AVX2 and FMA, else SSE2); one build runs anywhere, and takes the best one that the machine has:
///
///   SWAPLIGHT_SIMD(void, scale, (float* values, float factor, int count), (values, factor, count)) {
///     for (int p = 0; p < count; ++p) values[p] *= factor;
///   }
///
/// defines `static void scale(float* values, float factor, int count)`. Only the function itself is compiled
/// again, with what is inlined into it: write loops in it, not lambdas, and mark helpers `inline`. Not for
/// templates. Results may differ in the last bit between machines, because v3 and v4 fuse multiplications and
/// additions. (GCC's target_clones would save the list of arguments, but what it chooses no test can force.)
#if defined(__x86_64__)
#define SWAPLIGHT_SIMD(result, name, parameters, arguments)                 \
  [[gnu::always_inline]] static inline result name##Loop parameters;        \
  [[gnu::target("arch=x86-64-v4")]] static result name##Level4 parameters { \
    return name##Loop arguments;                                            \
  }                                                                         \
  [[gnu::target("arch=x86-64-v3")]] static result name##Level3 parameters { \
    return name##Loop arguments;                                            \
  }                                                                         \
  static result name##Level1 parameters {                                   \
    return name##Loop arguments;                                            \
  }                                                                         \
  static result name parameters {                                           \
    if (swaplight::processorLevel() == 4) return name##Level4 arguments;    \
    if (swaplight::processorLevel() == 3) return name##Level3 arguments;    \
    return name##Level1 arguments;                                          \
  }                                                                         \
  static inline result name##Loop parameters
#else
#define SWAPLIGHT_SIMD(result, name, parameters, arguments) static result name parameters
#endif

/// Kernels written in lanes (core/simd/lanes.h) are files named *_kernel.cpp. They are compiled whole, once
/// for each class of processor (SWAPLIGHT_LEVEL: level1, level3, level4; see cmake/SwaplightLibrary.cmake),
/// as wide as its registers. They include nothing that a linker could mistake for code of the rest of the
/// program.
///
/// SWAPLIGHT_DECLARE_KERNEL(name, parameters...) declares void name(parameters...) for every class;
/// SWAPLIGHT_KERNEL(name) is the one for this machine.
#if defined(__x86_64__) && !defined(SWAPLIGHT_ONE_LEVEL)
#define SWAPLIGHT_DECLARE_KERNEL(name, ...) \
  namespace level1 {                        \
  void name(__VA_ARGS__);                   \
  }                                         \
  namespace level3 {                        \
  void name(__VA_ARGS__);                   \
  }                                         \
  namespace level4 {                        \
  void name(__VA_ARGS__);                   \
  }
#define SWAPLIGHT_KERNEL(name)                       \
  (swaplight::processorLevel() == 4   ? level4::name \
   : swaplight::processorLevel() == 3 ? level3::name \
                                      : level1::name)
#else
#define SWAPLIGHT_DECLARE_KERNEL(name, ...) \
  namespace level1 {                        \
  void name(__VA_ARGS__);                   \
  }
#define SWAPLIGHT_KERNEL(name) level1::name
#endif

namespace swaplight {

/// The class of this machine's processor, as in x86-64-v4: 4, 3 or 1.
[[nodiscard]] int machineLevel();

/// The class whose code runs: the machine's, or a lower one where the environment variable
/// SWAPLIGHT_PROCESSOR_LEVEL (1, 3 or 4) asks for it. Throws InputError where that holds anything else.
[[nodiscard]] int processorLevel();

/// Makes the code of a lower class run from now on, on all threads; never that of a higher one than the
/// machine's. For tests.
void setProcessorLevel(int level);

}  // namespace swaplight
