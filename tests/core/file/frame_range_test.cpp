#include "core/file/frame_range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using ::testing::HasSubstr;
using Frames = std::vector<int>;

TEST(FrameRange, EachFrameOnceInTheOrderGiven) {
  EXPECT_EQ(framesFromRange("3"), Frames({3}));
  EXPECT_EQ(framesFromRange("1-10x3 5,4"), Frames({1, 4, 7, 10, 5}));
  EXPECT_EQ(framesFromRange("-8--5"), Frames({-8, -7, -6, -5}));
  EXPECT_EQ(framesFromRange("5-1x2"), Frames({5, 3, 1}));
  EXPECT_EQ(framesFromRange("1-10x999999999"), Frames({1}));
}

TEST(FrameRange, AMillionFramesAreMany) {
  EXPECT_EQ(framesFromRange("1-1000000").size(), 1000000U);
  EXPECT_THROW(static_cast<void>(framesFromRange("0-1000000")), InputError);
  EXPECT_THROW(static_cast<void>(framesFromRange("-999999999-999999999")), InputError);
  for (const char* text : {"1-1000000000", "1-99999999999", "-5000000000-5000000000"})
    EXPECT_THAT(inputError([&] { static_cast<void>(framesFromRange(text)); }),
                HasSubstr("more than a million"));
  EXPECT_THAT(inputError([] { static_cast<void>(framesFromRange("1000000000")); }), HasSubstr("nine digits"));
}

TEST(FrameRange, ASignCountsAsADigitAsInPrintf) {
  EXPECT_EQ(frameName("a.%04d.exr", -1), "a.-001.exr");
  EXPECT_EQ(frameName("a.####.exr", -12), "a.-012.exr");
  EXPECT_EQ(frameName("a.#.exr", -12), "a.-012.exr");
  EXPECT_EQ(frameName("a.%d.exr", -3), "a.-3.exr");
  EXPECT_EQ(frameName("a.@@.exr", -1234), "a.-1234.exr");
  EXPECT_EQ(frameName("a.%04d.exr", 7), "a.0007.exr");
}

// Found by fuzzing: a short text that asks for the same frames again and again took minutes.
TEST(FrameRange, ThoseThatComeAgainAreCounted) {
  std::string text = "1-999999";
  for (int i = 0; i < 1000; ++i) text += ",1-999999";
  EXPECT_THROW(static_cast<void>(framesFromRange(text)), InputError);
}

}  // namespace
}  // namespace swaplight
