#include "core/look/look_place.h"

#include <cmath>

#include "core/base/number_text.h"

namespace swaplight {

std::optional<size_t> placeOfLook(const std::vector<SavedLook>& looks, const std::string& text) {
  if (const SavedLook* named = findSavedLook(looks, text)) return static_cast<size_t>(named - looks.data());
  const std::optional<float> number = numberFromText(text);
  if (!number || *number < 1 || *number > static_cast<float>(looks.size()) || *number != std::floor(*number))
    return std::nullopt;
  return static_cast<size_t>(*number) - 1;
}

}  // namespace swaplight
