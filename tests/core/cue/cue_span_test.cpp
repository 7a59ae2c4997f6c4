#include "core/cue/cue_span.h"

#include <gtest/gtest.h>

#include "core/cue/cue_timeline.h"

namespace swaplight {
namespace {

constexpr double kHold = 1, kStep = .1;

/// Three cues: the first is followed after 2 s, the second waits for GO.
CueList show() {
  return {{100, "A", 5, 2.F}, {200, "B", 3, {}}, {300, "C", 1.5F, {}}};
}

TEST(CueSpan, TimesAreThoseOfTheTimeline) {
  const std::vector<SavedLook> looks = {{"A", "", {}, {}}, {"B", "", {}, {}}, {"C", "", {}, {}}};
  const CueTiming timing{100, kHold, 0};
  const CueTimeline timeline(show(), looks, {}, timing);
  const std::vector<CueSpan> spans = cueSpans(show(), kHold);
  ASSERT_EQ(spans.size(), 3U);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(timeline.places()[i].begins, std::lround(100 * spans[i].begins)) << i;
    EXPECT_EQ(timeline.places()[i].stands, std::lround(100 * spans[i].stands)) << i;
    EXPECT_EQ(timeline.places()[i].ends, std::lround(100 * spans[i].ends)) << i;
  }
  EXPECT_FALSE(spans[0].waits);
  EXPECT_TRUE(spans[1].waits);
  EXPECT_TRUE(spans[2].waits);
}

TEST(CueSpan, ACueThatBeginsLaterLetsTheOneBeforeStandLonger) {
  const CueList moved = withCueBegin(show(), 200, 3.5, kHold, kStep);
  EXPECT_FLOAT_EQ(*moved[0].followSeconds, 3.5F);
  EXPECT_EQ(moved[1], show()[1]);
  EXPECT_DOUBLE_EQ(cueSpans(moved, kHold)[2].begins - cueSpans(show(), kHold)[2].begins, 1.5);
}

TEST(CueSpan, ACueAfterGoFollowsOnceItsBeginIsMoved) {
  const CueList moved = withCueBegin(show(), 300, 5.74, kHold, kStep);
  ASSERT_TRUE(moved[1].followSeconds);
  EXPECT_FLOAT_EQ(*moved[1].followSeconds, .7F);
}

TEST(CueSpan, NothingBeginsBeforeTheOneBeforeStands) {
  EXPECT_EQ(*withCueBegin(show(), 200, -4, kHold, kStep)[0].followSeconds, 0);
  EXPECT_EQ(withCueStand(show(), 200, 0, kHold, kStep)[1].fadeSeconds, 0);
  EXPECT_EQ(withCueStand(show(), 200, 1e9, kHold, kStep)[1].fadeSeconds, kMostCueSeconds);
}

TEST(CueSpan, AFadeIsAsLongAsItIsDragged) {
  const CueList moved = withCueStand(show(), 300, 8.04, kHold, kStep);
  EXPECT_FLOAT_EQ(moved[2].fadeSeconds, 2.F);  // begins at 6
  EXPECT_FLOAT_EQ(withCueStand(show(), 300, 8.04, kHold, .01)[2].fadeSeconds, 2.04F);
}

TEST(CueSpan, TheFirstCueAndOneThatIsNotThereStay) {
  for (const int number : {100, 250}) {
    EXPECT_EQ(withCueBegin(show(), number, 4, kHold, kStep), show());
    EXPECT_EQ(withCueStand(show(), number, 4, kHold, kStep), show());
  }
}

}  // namespace
}  // namespace swaplight
