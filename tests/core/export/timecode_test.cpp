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

constexpr PackedTime kSecondOfPair = 1U << 15;  // the field flag of OpenEXR's TV60 packing

TEST(Timecode, AboveThirtyFramesASecondPairsAreCountedAndTheFieldFlagTellsTheirFrames) {
  for (const int fps : {48, 50, 60}) {
    PackedTime time = 0x01020300;
    for (int i = 0; i < 3 * fps; ++i) {
      const PackedTime pair = static_cast<PackedTime>(i % fps / 2);
      const PackedTime expected = 0x01020300U + static_cast<PackedTime>(i / fps) * 0x100U +
                                  (pair / 10 << 4 | pair % 10) + (i % 2 == 1 ? kSecondOfPair : 0);
      ASSERT_EQ(time, expected) << fps << " a second, frame " << i;
      ASSERT_EQ(advanced(0x01020300, i, fps), expected) << fps << " a second, frame " << i;
      ASSERT_EQ(advanced(time, -i, fps), 0x01020300U) << fps << " a second, frame " << i;
      time = advanced(time, 1, fps);
    }
  }
  EXPECT_EQ(advanced(0x23595924 | kSecondOfPair, 1, 50), 0x00000000U) << "midnight";
}

TEST(Timecode, DropFrameAtSixtyLeavesOutTwoPairsAMinute) {
  constexpr PackedTime drop = 1U << 6;
  EXPECT_EQ(advanced(0x00005929 | drop | kSecondOfPair, 1, 60), 0x00010002U | drop);
  EXPECT_EQ(advanced(0x00095929 | drop | kSecondOfPair, 1, 60), 0x00100000U | drop);
  EXPECT_EQ(advanced(0x00000000 | drop, 35964, 60), 0x00100000U | drop) << "ten minutes at 59.94";
}

std::shared_ptr<const CarriedData> shotAt(int frames, int seconds) {
  auto carried = std::make_shared<CarriedData>();
  carried->header["smpte:TimeCode"] = {HeaderValue::Kind::Timecode, {}, {0x01020304, 0}, {}};
  carried->header["FramesPerSecond"] = {HeaderValue::Kind::Rational, {}, {frames, seconds}, {}};
  return carried;
}

TEST(Timecode, GoesOnAtTheRateOfTheHeader) {
  const auto later = [](int frames, int seconds) {
    return withTimecode(shotAt(frames, seconds), 61)->header.at("smpte:TimeCode").integers.at(0);
  };
  EXPECT_EQ(later(25, 1), 0x01020515);
  EXPECT_EQ(later(60000, 1001), 0x01020404 | static_cast<int>(kSecondOfPair));
}

TEST(Timecode, ARateThatTimeCodesCannotCountGivesNone) {
  for (const int fps : {45, 120}) {
    const auto shot = shotAt(fps, 1);
    EXPECT_EQ(withTimecode(shot, 0), shot);
    EXPECT_FALSE(withTimecode(shot, 1)->header.contains("smpte:TimeCode")) << fps;
  }
}

}  // namespace
}  // namespace swaplight
