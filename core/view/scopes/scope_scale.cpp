#include "core/view/scopes/scope_scale.h"

#include <fmt/format.h>

namespace swaplight {
namespace {

constexpr float kLeastApart = .07F;  // of the scale: numbers would overlap

std::vector<ScopeTick> evenTicks(int most) {
  std::vector<ScopeTick> ticks;
  for (const int quarter : {0, 1, 2, 3, 4}) {
    const int value = quarter == 4 ? most : quarter * ((most + 3) / 4);
    ticks.push_back({static_cast<float>(value) / static_cast<float>(most), std::to_string(value)});
  }
  return ticks;
}

/// 1, 2, 5, 10 ... as far as the display goes, and what it shows at most.
std::vector<ScopeTick> nitTicks(const DisplayLuminance& shown) {
  const float most = shown.nits(1);
  std::vector<ScopeTick> ticks{{0, "0"}};
  for (float decade = 1; decade < most; decade *= 10)
    for (const float step : {1.F, 2.F, 5.F}) {
      const float nits = step * decade, place = shown.code(nits);
      if (nits < most && place - ticks.back().place > kLeastApart && 1 - place > kLeastApart)
        ticks.push_back({place, fmt::format("{:.0f}", nits)});
    }
  ticks.push_back({1, fmt::format("{:.0f}", most)});
  return ticks;
}

}  // namespace

std::vector<ScopeTick> scopeTicks(ScopeUnit unit, const DisplayLuminance& shown) {
  switch (unit) {
    case ScopeUnit::Codes8:
      return evenTicks(255);
    case ScopeUnit::Codes10:
      return evenTicks(1023);
    case ScopeUnit::Nits:
      if (shown.known()) return nitTicks(shown);
      break;
    case ScopeUnit::Percent:
      break;
  }
  return evenTicks(100);
}

}  // namespace swaplight
