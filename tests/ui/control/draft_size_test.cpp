#include "ui/camera/draft_size.h"

#include <gtest/gtest.h>

#include <cmath>

namespace swaplight {
namespace {

using Filters = std::vector<std::string>;

/// The scale after drafts of a look that takes `seconds` at full size, and `power` of the side's share.
float settledScale(DraftSize& size, const Filters& filters, double seconds, double power) {
  for (int i = 0; i < 20; ++i) {
    const float scale = size.scaleFor(filters);
    size.tell(scale, seconds * std::pow(scale, power));
  }
  return size.scaleFor(filters);
}

TEST(DraftSize, WhatIsCheapIsDrawnAtFullSizeAndWhatIsDearSmall) {
  DraftSize size;
  EXPECT_FLOAT_EQ(size.scaleFor({"a"}), 0.26F) << "nothing is known";
  EXPECT_FALSE(size.isQuick());
  EXPECT_FLOAT_EQ(settledScale(size, {"a"}, 0.004, 2), 1);
  EXPECT_TRUE(size.isQuick());
  EXPECT_FLOAT_EQ(settledScale(size, {"b"}, 0.06, 2), 0.36F);
  EXPECT_FLOAT_EQ(settledScale(size, {"c"}, 2, 3), 0.26F);
  EXPECT_FALSE(size.isQuick());
}

TEST(DraftSize, StaysWhereItIsWhileTheTimesDo) {
  for (const double power : {2.0, 3.0})
    for (double seconds = 0.004; seconds < 1; seconds *= 1.07) {
      DraftSize size;
      const float scale = settledScale(size, {"a"}, seconds, power);
      for (int i = 0; i < 4; ++i) {
        size.tell(scale, seconds * std::pow(scale, power));
        ASSERT_EQ(size.scaleFor({"a"}), scale) << seconds << " s, power " << power;
      }
    }
}

TEST(DraftSize, IsSmallerWhenTheMachineIsBusy) {
  DraftSize size;
  settledScale(size, {"a"}, 0.004, 2);
  size.tell(1, 0.05);
  EXPECT_LT(size.scaleFor({"a"}), 1);
}

}  // namespace
}  // namespace swaplight
