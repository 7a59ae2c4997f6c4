#include "core/simd/plane_arena.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>

namespace swaplight {
namespace {

TEST(PlaneArena, GivesPlanesThatDoNotOverlapAndHaveRoomForWholeLanes) {
  PlaneArena arena(37, 3);
  EXPECT_EQ(arena.padded(), 48U);
  float* planes[] = {arena.take(1), arena.take(2), arena.take(3)};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(reinterpret_cast<uintptr_t>(planes[i]) % 64, 0U);
    for (size_t p = 0; p < arena.padded(); ++p) ASSERT_EQ(planes[i][p], float(i + 1));
  }
}

TEST(PlaneArena, HasNoMoreThanItWasMadeWith) {
  PlaneArena arena(1, 1);
  (void)arena.take();
  EXPECT_THROW((void)arena.take(), std::logic_error);
}

TEST(PlaneArena, RoundsUpToWholeLanes) {
  EXPECT_EQ(roundedUpToLanes(0), 0U);
  EXPECT_EQ(roundedUpToLanes(1), size_t{kMostLanes});
  EXPECT_EQ(roundedUpToLanes(kMostLanes), size_t{kMostLanes});
  EXPECT_EQ(roundedUpToLanes(kMostLanes + 1), size_t{2 * kMostLanes});
}

}  // namespace
}  // namespace swaplight
