#pragma once

#include <memory>

#include "core/set/solved_set.h"

namespace swaplight {

/// Where a spot's light would be if nothing cast a shadow: one channel, 0 outside its cone to 1 inside, its
/// edge left out. What lies beyond is no shadow, though as dark as one. nullptr: the light does not surely
/// make a cone (core/edit/pool/light_cone.h), such as a sun between the shadows of houses, or is none of the
/// set's.
[[nodiscard]] std::shared_ptr<const Image> spotPool(const SolvedSet& set, size_t light);

}  // namespace swaplight
