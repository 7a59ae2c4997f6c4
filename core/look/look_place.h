#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/look/saved_look.h"

namespace swaplight {

/// The place in a gallery of the look that a person means: by its name (see sameLookName), else by its
/// number, from 1. Nothing where there is no such look.
[[nodiscard]] std::optional<size_t> placeOfLook(const std::vector<SavedLook>& looks, const std::string& text);

}  // namespace swaplight
