#pragma once

#include <map>
#include <string>
#include <vector>

namespace swaplight {

/// What a person says of a place: one light reaches it, or does not.
struct ShadowMark {
  enum class Kind { Shadow, Lit };
  Kind is = Kind::Shadow;
  int x = 0, y = 0;  ///< a pixel of the solved set's picture
  bool operator==(const ShadowMark&) const = default;
};

/// "lit" or "shadow", as files and options say it.
[[nodiscard]] inline const char* wordFor(ShadowMark::Kind is) {
  return is == ShadowMark::Kind::Lit ? "lit" : "shadow";
}

/// In the order in which they were made: of two that contradict each other in a pixel the later one holds.
using ShadowMarks = std::vector<ShadowMark>;
/// By the light's name.
using ShadowMarksByLight = std::map<std::string, ShadowMarks>;

}  // namespace swaplight
