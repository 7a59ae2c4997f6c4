#include "core/capture/lightings.h"

#include <algorithm>

namespace swaplight {

bool litAlike(const Shot& a, const Shot& b) {
  if (a.crossed != b.crossed || a.lightColors.size() != b.lightColors.size()) return false;
  for (size_t i = 0; i < a.lightColors.size(); ++i) {
    if (a.lightColors[i] != b.lightColors[i]) return false;
    if (!a.lightColors[i] && (a.colorName(i).empty() || a.colorName(i) != b.colorName(i))) return false;
  }
  return true;
}

std::vector<int> lightingsOf(const std::vector<Shot>& shots) {
  std::vector<int> lightings;
  int next = 0;
  for (size_t k = 0; k < shots.size(); ++k) {
    size_t like = 0;
    while (like < k && !litAlike(shots[like], shots[k])) ++like;
    lightings.push_back(like < k ? lightings[like] : next++);
  }
  return lightings;
}

}  // namespace swaplight
