#pragma once

#include <cmath>

// What runs on the GPU as well as on the CPU: nvcc compiles it for both, a C++ compiler for the CPU.
#ifdef __CUDACC__
#define BOTH __host__ __device__
#else
#define BOTH
#endif

namespace training {

constexpr float kPi = 3.14159265F;

/// A point or direction in metres (x right, y away from the camera, z up), or a linear R G B colour.
struct Vec3 {
  float x, y, z;
};

BOTH inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
BOTH inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
BOTH inline Vec3 operator*(Vec3 a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}
BOTH inline Vec3 operator*(Vec3 a, Vec3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
BOTH inline float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
BOTH inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
BOTH inline Vec3 normalized(Vec3 a) {
  return a * (1 / sqrtf(fmaxf(dot(a, a), 1e-20F)));
}

/// The direction at an angle of that cosine to the unit `axis`, turned about it by `angle` (radians).
BOTH inline Vec3 directionAround(Vec3 axis, float cosine, float angle) {
  const Vec3 a = normalized(fabsf(axis.x) < .7F ? cross(axis, Vec3{1, 0, 0}) : cross(axis, Vec3{0, 1, 0}));
  const Vec3 b = cross(axis, a);
  const float sine = sqrtf(fmaxf(0, 1 - cosine * cosine));
  return a * (sine * cosf(angle)) + b * (sine * sinf(angle)) + axis * cosine;
}

}  // namespace training
