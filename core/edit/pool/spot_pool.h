#pragma once

#include <memory>

#include "core/set/solved_set.h"

namespace swaplight {

/// Where a spot's light would be if nothing cast a shadow: one channel, 0 outside its cone to 1 inside, its
/// edge left out. What lies beyond is no shadow, though as dark as one. nullptr: the light makes no cone
/// (core/edit/pool/light_pool.h), or there is no such light in the set.
[[nodiscard]] std::shared_ptr<const Image> spotPool(const SolvedSet& set, size_t light);

}  // namespace swaplight
