#pragma once

#include <gtest/gtest.h>

#include "core/color/rgb.h"

namespace swaplight::test {

inline void expectNear(const Rgb& found, const Rgb& expected, float tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << "channel " << c;
}

}  // namespace swaplight::test
