#pragma once

#include "tests/train/scene.h"
#include "tests/train/vec3.h"

namespace training {

constexpr float kNearest = 1e-4F;  // metres: a ray meets nothing nearer than that

struct Hit {
  float distance;
  Vec3 normal;  // unit, towards where the ray comes from
  int solid;
};

/// Where a ray meets the unit shape: the distance, below the one given, and the normal there, of any length.
struct LocalHit {
  float distance;
  Vec3 normal;
  bool found;

  // Not an assignment of { ... }: it crashes nvcc 13.0.
  BOTH void set(float at, Vec3 n) {
    distance = at;
    normal = n;
    found = true;
  }
};

BOTH inline void intersectBox(Vec3 p, Vec3 r, LocalHit& hit) {
  const float ix = 1 / (fabsf(r.x) > 1e-12F ? r.x : 1e-12F), iy = 1 / (fabsf(r.y) > 1e-12F ? r.y : 1e-12F),
              iz = 1 / (fabsf(r.z) > 1e-12F ? r.z : 1e-12F);
  const float x0 = (-p.x - fabsf(ix) / ix) * ix, x1 = (-p.x + fabsf(ix) / ix) * ix;
  const float y0 = (-p.y - fabsf(iy) / iy) * iy, y1 = (-p.y + fabsf(iy) / iy) * iy;
  const float z0 = (-p.z - fabsf(iz) / iz) * iz, z1 = (-p.z + fabsf(iz) / iz) * iz;
  const float enters = fmaxf(x0, fmaxf(y0, z0)), leaves = fminf(x1, fminf(y1, z1));
  if (enters > leaves) return;
  const float at = enters > kNearest ? enters : leaves;
  if (at <= kNearest || at >= hit.distance) return;
  const Vec3 h = p + r * at;
  const float ax = fabsf(h.x), ay = fabsf(h.y), az = fabsf(h.z);
  hit.set(at, ax > ay && ax > az ? Vec3{h.x, 0, 0} : ay > az ? Vec3{0, h.y, 0} : Vec3{0, 0, h.z});
}

BOTH inline void intersectSphere(Vec3 p, Vec3 r, LocalHit& hit) {
  const float a = dot(r, r), b = dot(p, r), k = b * b - a * (dot(p, p) - 1);
  if (k < 0) return;
  const float w = sqrtf(k);
  float at = (-b - w) / a;
  if (at <= kNearest) at = (-b + w) / a;
  if (at <= kNearest || at >= hit.distance) return;
  hit.set(at, p + r * at);
}

/// The side: x^2 + y^2 = (f + g z)^2; then, where `capped`, the ends.
BOTH inline void intersectCylinder(Vec3 p, Vec3 r, float taper, bool capped, LocalHit& hit) {
  const float g = -.5F * taper, f = 1 - .5F * taper;
  const float w0 = f + g * p.z, w1 = g * r.z;
  const float a = r.x * r.x + r.y * r.y - w1 * w1, b = p.x * r.x + p.y * r.y - w0 * w1,
              c = p.x * p.x + p.y * p.y - w0 * w0, k = b * b - a * c;
  if (k >= 0 && fabsf(a) > 1e-12F) {
    const float w = sqrtf(k);
    for (int i = 0; i < 2; ++i) {
      const float at = (-b + (i ? w : -w)) / a, z = p.z + r.z * at;
      if (at > kNearest && at < hit.distance && fabsf(z) <= 1)
        hit.set(at, Vec3{p.x + r.x * at, p.y + r.y * at, -g * (f + g * z)});
    }
  }
  if (!capped || !(fabsf(r.z) > 1e-9F)) return;
  for (int i = 0; i < 2; ++i) {
    const float z = i ? 1.F : -1.F, at = (z - p.z) / r.z, x = p.x + r.x * at, y = p.y + r.y * at,
                w = f + g * z;
    if (at > kNearest && at < hit.distance && x * x + y * y <= w * w) hit.set(at, Vec3{0, 0, z});
  }
}

/// Whether a ray from `origin` along the unit `direction` meets the solid nearer than `farthest`; where, and
/// if `wanted` the unit normal there.
BOTH inline bool intersects(const Solid& solid, Vec3 origin, Vec3 direction, float farthest, float& distance,
                            Vec3& normal, bool wanted) {
  const Vec3 c = solid.at - origin;
  const float along = dot(c, direction);
  if (dot(c, c) - along * along > solid.bound * solid.bound) return false;
  const Vec3 q = origin - solid.at;
  const Vec3 p{dot(q, solid.localX), dot(q, solid.localY), dot(q, solid.localZ)};
  const Vec3 r{dot(direction, solid.localX), dot(direction, solid.localY), dot(direction, solid.localZ)};
  LocalHit hit{farthest, {0, 0, 0}, false};
  if (solid.shape == kBox)
    intersectBox(p, r, hit);
  else if (solid.shape == kSphere)
    intersectSphere(p, r, hit);
  else
    intersectCylinder(p, r, solid.taper, solid.shape == kCylinder, hit);
  if (!hit.found) return false;
  distance = hit.distance;
  const Vec3 m = hit.normal;
  if (wanted) normal = normalized(solid.localX * m.x + solid.localY * m.y + solid.localZ * m.z);
  return true;
}

/// The first solid that a ray meets.
BOTH inline bool castRay(const Scene& scene, Vec3 origin, Vec3 direction, Hit& hit) {
  hit.distance = 1e9F;
  hit.solid = -1;
  for (int i = 0; i < scene.solidCount; ++i)
    if (intersects(scene.solids[i], origin, direction, hit.distance, hit.distance, hit.normal, true))
      hit.solid = i;
  if (hit.solid < 0) return false;
  if (dot(hit.normal, direction) > 0) hit.normal = hit.normal * -1;
  return true;
}

/// Whether anything stands on the first `farthest` metres of a ray.
BOTH inline bool isBlocked(const Scene& scene, Vec3 origin, Vec3 direction, float farthest) {
  float distance;
  Vec3 normal;
  for (int i = 0; i < scene.solidCount; ++i)
    if (intersects(scene.solids[i], origin, direction, farthest, distance, normal, false)) return true;
  return false;
}

}  // namespace training
