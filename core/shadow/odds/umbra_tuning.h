#pragma once

#include <tuple>
#include <utility>

namespace swaplight {

/// Of the odds of umbra (umbra_odds.h).
struct UmbraOddsTuning {
  int longest = 480;  ///< pixels of the longer side of the picture that evidence is weighed on
  float pooling = 3;  ///< units over which odds are pooled, where neither light nor others have an edge ...
  float edge = .6F;   ///< ... of so much, log

  static constexpr auto fields() {
    using T = UmbraOddsTuning;
    return std::tuple{std::pair{"longest", &T::longest}, std::pair{"pooling", &T::pooling},
                      std::pair{"edge", &T::edge}};
  }
};

}  // namespace swaplight
