#pragma once

/// Put before a function whose loops the compiler should vectorise: it is compiled once for each class of
/// x86-64 processor (v4: AVX-512, v3: AVX2 and FMA, default: SSE2), and the best one that the machine has is
/// chosen when the program starts; one build runs anywhere. Only the function itself is cloned, with what is
/// inlined into it: write loops in it, not lambdas, and mark helpers `inline`. Not for templates. Results may
/// differ in the last bit between machines, because v3 and v4 fuse multiplications and additions.
///
/// Empty under the sanitizers, which cannot run the resolver, and for compilers other than g++.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(SWAPLIGHT_SANITIZE)
#define SWAPLIGHT_SIMD __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define SWAPLIGHT_SIMD
#endif

/// Kernels written in lanes (core/simd/lanes.h) are files named *_kernel.cpp. They are compiled whole, once
/// for each class of processor (SWAPLIGHT_LEVEL: level1, level3, level4; see core/CMakeLists.txt): vectors
/// wider than the processor that a helper is first compiled for would be taken apart before it is inlined.
/// They include nothing that a linker could mistake for code of the rest of the program.
///
/// SWAPLIGHT_DECLARE_KERNEL(name, parameters...) declares void name(parameters...) for every class;
/// SWAPLIGHT_KERNEL(name) is the one for this machine.
#if defined(__x86_64__) && !defined(SWAPLIGHT_SANITIZE)
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
[[nodiscard]] int processorLevel();

}  // namespace swaplight
