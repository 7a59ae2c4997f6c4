#include "core/base/option_hints.h"

#include <gtest/gtest.h>

namespace swaplight {
namespace {

TEST(OptionHints, AreLeftOutForWhoHasButtons) {
  EXPECT_EQ(withoutOptionHints("even them in the solve (--field), or photograph a card (--flat)"),
            "even them in the solve, or photograph a card");
  EXPECT_EQ(withoutOptionHints("they were aligned (--align off leaves them as they are)"),
            "they were aligned");
}

TEST(OptionHints, OtherBracketsAndWhatIsNotClosedStay) {
  EXPECT_EQ(withoutOptionHints("a curve (light to the power of 0.9)"), "a curve (light to the power of 0.9)");
  EXPECT_EQ(withoutOptionHints("align them (--align on"), "align them (--align on");
  EXPECT_EQ(withoutOptionHints(""), "");
}

}  // namespace
}  // namespace swaplight
