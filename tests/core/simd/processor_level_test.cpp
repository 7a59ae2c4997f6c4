#include <gtest/gtest.h>

#include <cstdlib>

#include "core/base/error.h"
#include "core/simd/simd.h"
#include "tests/core/simd/kernels/lane_maths_kernel.h"
#include "tests/support/processor_levels.h"

namespace swaplight::test {
namespace {

SWAPLIGHT_SIMD(int, sumOf, (const int* values, int count), (values, count)) {
  int sum = 0;
  for (int i = 0; i < count; ++i) sum += values[i];
  return sum;
}

TEST(ProcessorLevel, IsTheMachinesUnlessALowerOneIsAskedFor) {
  EXPECT_EQ(processorLevel(), std::getenv("SWAPLIGHT_PROCESSOR_LEVEL") ? processorLevel() : machineLevel());
  const int before = processorLevel();
  atEveryLevel([] { EXPECT_LE(processorLevel(), machineLevel()); });
  EXPECT_EQ(processorLevel(), before);
  const AtLevel tooHigh(4);
  EXPECT_EQ(processorLevel(), machineLevel() >= 4 ? 4 : machineLevel()) << "never above what the machine has";
}

TEST(ProcessorLevel, DecidesWhichKernelRuns) {
  const AtLevel plain(1);
  EXPECT_EQ(SWAPLIGHT_KERNEL(logarithms), level1::logarithms);
#if defined(__x86_64__) && !defined(SWAPLIGHT_ONE_LEVEL)
  const int best = machineLevel();
  const AtLevel three(3);
  EXPECT_EQ(SWAPLIGHT_KERNEL(logarithms), best >= 3 ? level3::logarithms : level1::logarithms);
  const AtLevel four(4);
  EXPECT_EQ(SWAPLIGHT_KERNEL(logarithms), best >= 4   ? level4::logarithms
                                          : best == 3 ? level3::logarithms
                                                      : level1::logarithms);
#endif
}

TEST(ProcessorLevel, ALoopReturnsWhatItReturnsAtEveryLevel) {
  std::vector<int> values(101);
  for (size_t i = 0; i < values.size(); ++i) values[i] = int(i * i);
  atEveryLevel([&] { EXPECT_EQ(sumOf(values.data(), 101), 338350); });
}

/// In a process of its own, which has not asked for its level yet.
[[noreturn]] void tellLevel(const char* asked) {
  setenv("SWAPLIGHT_PROCESSOR_LEVEL", asked, 1);  // NOLINT(concurrency-mt-unsafe)
  try {
    std::exit(processorLevel());  // NOLINT(concurrency-mt-unsafe)
  } catch (const InputError& error) {
    std::fputs(error.what(), stderr);
    std::exit(22);  // NOLINT(concurrency-mt-unsafe)
  }
}

TEST(ProcessorLevelDeathTest, CanBeForcedFromOutside) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(tellLevel("1"), testing::ExitedWithCode(1), "");
  EXPECT_EXIT(tellLevel("3"), testing::ExitedWithCode(std::min(3, machineLevel())), "");
  EXPECT_EXIT(tellLevel("4"), testing::ExitedWithCode(machineLevel()), "");
}

TEST(ProcessorLevelDeathTest, WhatIsNoLevelIsBadInput) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const char* asked : {"", "2", "5", "avx2", "-1"})
    EXPECT_EXIT(tellLevel(asked), testing::ExitedWithCode(22), "SWAPLIGHT_PROCESSOR_LEVEL is .*1, 3 or 4");
}

}  // namespace
}  // namespace swaplight::test
