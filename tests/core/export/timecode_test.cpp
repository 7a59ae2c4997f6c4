#include "core/export/timecode.h"

#include <gtest/gtest.h>

namespace swaplight {
namespace {

TEST(Timecode, CountsFramesSecondsMinutesAndHours) {
  EXPECT_EQ(advanced(0x01020304, 1, 24), 0x01020305U);
  EXPECT_EQ(advanced(0x01020323, 1, 24), 0x01020400U);
  EXPECT_EQ(advanced(0x01595923, 1, 24), 0x02000000U);
  EXPECT_EQ(advanced(0x23595924, 1, 25), 0x00000000U) << "midnight";
  EXPECT_EQ(advanced(0x00000000, -1, 25), 0x23595924U);
  EXPECT_EQ(advanced(0x01020304, 0, 24), 0x01020304U);
}

TEST(Timecode, DropFrameLeavesOutTwoNumbersAMinuteButNotEveryTenth) {
  constexpr PackedTime drop = 1U << 6;
  EXPECT_EQ(advanced(0x00005929 | drop, 1, 30), 0x00010002U | drop);
  EXPECT_EQ(advanced(0x00095929 | drop, 1, 30), 0x00100000U | drop);
  EXPECT_EQ(advanced(0x00000000 | drop, 17982, 30), 0x00100000U | drop) << "ten minutes at 29.97";
  EXPECT_EQ(advanced(0x01000000 | drop, -107892, 30), 0x00000000U | drop);
  PackedTime time = drop;
  for (int i = 0; i < 20000; ++i) {
    EXPECT_EQ(advanced(advanced(time, 1, 30), -1, 30), time);
    time = advanced(time, 1, 30);
    EXPECT_EQ(time, advanced(drop, i + 1, 30));
  }
}

}  // namespace
}  // namespace swaplight
