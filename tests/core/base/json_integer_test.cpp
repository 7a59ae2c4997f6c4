#include "core/base/json_integer.h"

#include <gtest/gtest.h>

#include <limits>

namespace swaplight {
namespace {

TEST(JsonInteger, IsAWholeNumberThatAnIntHolds) {
  EXPECT_EQ(integerOf(Json::parse("0")), 0);
  EXPECT_EQ(integerOf(Json::parse("2147483647")), std::numeric_limits<int>::max());
  EXPECT_EQ(integerOf(Json::parse("-2147483648")), std::numeric_limits<int>::min());
}

TEST(JsonInteger, IsNothingWhereAnIntWouldHoldAnotherNumber) {
  for (const char* text : {"2147483648", "4294967297", "-2147483649", "-4294967295", "9223372036854775808",
                           "18446744073709551615", "1e30", "1.5", "1.0", "\"1\"", "true", "null", "[1]"})
    EXPECT_EQ(integerOf(Json::parse(text)), std::nullopt) << text;
}

}  // namespace
}  // namespace swaplight
