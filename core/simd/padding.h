#pragma once

#include <cstddef>

namespace swaplight {

/// The most pixels that a kernel takes at once (core/simd/lanes.h), on any processor: a cache line of floats.
inline constexpr int kMostLanes = 16;

/// Pixels that a plane needs room for, so that the last lanes may reach beyond its `count`.
constexpr size_t roundedUpToLanes(size_t count) {
  return (count + kMostLanes - 1) / kMostLanes * kMostLanes;
}

}  // namespace swaplight
