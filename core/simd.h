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
