#pragma once

#include <fmt/core.h>

#include <stdexcept>

namespace swaplight {

/// What a caller must see to, said where it is relied on. Where it does not hold, the program is wrong (for
/// what a person may get wrong there is InputError): throws std::logic_error with the place, the condition
/// and both values. Throws rather than aborts, so that the studio can still save what is open.
///
///   SWAPLIGHT_CHECK(at < m_planes.size());
///   SWAPLIGHT_CHECK_EQ(factors.size(), set.contributions.size());
#define SWAPLIGHT_CHECK(condition)                                                                          \
  do {                                                                                                      \
    if (!(condition)) throw std::logic_error(fmt::format("{}:{}: not {}", __FILE__, __LINE__, #condition)); \
  } while (false)

#define SWAPLIGHT_CHECK_EQ(a, b) SWAPLIGHT_CHECK_IMPLEMENTATION(a, ==, b)
#define SWAPLIGHT_CHECK_LE(a, b) SWAPLIGHT_CHECK_IMPLEMENTATION(a, <=, b)
#define SWAPLIGHT_CHECK_LT(a, b) SWAPLIGHT_CHECK_IMPLEMENTATION(a, <, b)

#define SWAPLIGHT_CHECK_IMPLEMENTATION(a, relation, b)                                             \
  do {                                                                                             \
    const auto& checkedLeft = (a);                                                                 \
    const auto& checkedRight = (b);                                                                \
    if (!(checkedLeft relation checkedRight))                                                      \
      throw std::logic_error(fmt::format("{}:{}: not {} {} {}: {} and {}", __FILE__, __LINE__, #a, \
                                         #relation, #b, checkedLeft, checkedRight));               \
  } while (false)

}  // namespace swaplight
