#pragma once

#include <cstdint>

#include "tests/train/vec3.h"

namespace training {

/// Random numbers for a pixel's paths: PCG (O'Neill, "PCG", 2014), 24 bits of each state.
struct PathRandom {
  uint32_t state;

  /// 0 <= x < 1.
  BOTH float next() {
    state = state * 747796405U + 2891336453U;
    uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737U;
    word = (word >> 22) ^ word;
    return (word >> 8) * (1.F / 16777216);
  }
};

BOTH inline uint32_t hashOf(int x, int y, int z) {
  uint32_t h = uint32_t(x) * 73856093U ^ uint32_t(y) * 19349663U ^ uint32_t(z) * 83492791U;
  h ^= h >> 16;
  h *= 0x7feb352dU;
  h ^= h >> 15;
  h *= 0x846ca68bU;
  h ^= h >> 16;
  return h;
}

BOTH inline float latticeNoise(int x, int y, int z) {
  return (hashOf(x, y, z) >> 8) * (1.F / 16777216);
}

/// Value noise, 0 to 1, with details about a unit apart: the lattice's values, smoothly interpolated.
BOTH inline float smoothNoise(Vec3 p) {
  const float fx = floorf(p.x), fy = floorf(p.y), fz = floorf(p.z);
  float x = p.x - fx, y = p.y - fy, z = p.z - fz;
  x = x * x * (3 - 2 * x);
  y = y * y * (3 - 2 * y);
  z = z * z * (3 - 2 * z);
  float v = 0;
  for (int i = 0; i < 8; ++i)
    v += latticeNoise(int(fx) + (i & 1), int(fy) + (i >> 1 & 1), int(fz) + (i >> 2)) * (i & 1 ? x : 1 - x) *
         (i & 2 ? y : 1 - y) * (i & 4 ? z : 1 - z);
  return v;
}

}  // namespace training
