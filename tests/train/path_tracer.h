#pragma once

#include "tests/train/intersection.h"
#include "tests/train/noise.h"
#include "tests/train/scene.h"
#include "tests/train/vec3.h"

namespace training {

constexpr float kOffset = 2e-4F;  // metres: rays leave a surface so far above it

/// What a pixel gets of each lamp.
constexpr int kLightFloats = kMostLamps * 3;  // R G B
constexpr int kSeenFloats = kMostLamps * 2;   // directly with shadows, and directly if nothing stood between

BOTH inline Vec3 albedoAt(const Material& material, Vec3 p, const Solid& solid) {
  const Vec3 q = (p - solid.at) * (1 / material.scale);
  bool other = false;
  float mix = 0;
  if (material.pattern == kChecker) {
    other = (int(floorf(q.x + .01F)) + int(floorf(q.y + .01F)) + int(floorf(q.z + .01F))) & 1;
  } else if (material.pattern == kStripes) {
    other = int(floorf(q.x + q.z * .5F + q.y * .3F)) & 1;
  } else if (material.pattern == kBricks) {
    const float row = floorf(q.z * 2), h = q.z * 2 - row, l = q.x + q.y + (int(row) & 1 ? .5F : 0),
                w = l - floorf(l);
    other = h < .1F || w < .05F;
    mix = .5F * latticeNoise(int(floorf(l)), int(row), 7);
  } else if (material.pattern == kClouds) {
    mix = smoothNoise(q) * .6F + smoothNoise(q * 2.1F) * .3F + smoothNoise(q * 4.3F) * .1F;
  } else if (material.pattern == kGrain) {
    mix = smoothNoise(Vec3{q.x * 1.5F, q.y * 1.5F, q.z * 9});
  }
  if (other) return material.other;
  return material.one * (1 - mix) + material.other * mix;
}

/// The normal, turned along the slope of noise where the material has a relief.
BOTH inline Vec3 shadingNormal(const Material& material, Vec3 p, Vec3 normal) {
  Vec3 n = normal;
  if (material.relief > 0) {
    const Vec3 q = p * (4 / material.scale);
    const float h = smoothNoise(q);
    const Vec3 slope{smoothNoise(q + Vec3{.1F, 0, 0}) - h, smoothNoise(q + Vec3{0, .1F, 0}) - h,
                     smoothNoise(q + Vec3{0, 0, .1F}) - h};
    n = normalized(n - (slope - n * dot(slope, n)) * (10 * material.relief));
  }
  return n;
}

/// A point of a lamp as seen from `p`: the direction to it, its distance, and what arrives from there, before
/// the cosine of the surface that receives it.
BOTH inline float sampleLamp(const Lamp& lamp, Vec3 p, PathRandom& random, Vec3& direction, float& distance) {
  const float a = random.next(), b = random.next();
  if (lamp.kind == kSun) {
    direction = directionAround(lamp.aim * -1, 1 - a * (1 - lamp.cosOuter), 2 * kPi * b);
    distance = 1e9F;
    return lamp.power;
  }
  if (lamp.kind == kDome) {
    direction = directionAround(Vec3{0, 0, 1}, a, 2 * kPi * b);
    distance = 1e9F;
    return lamp.power * 2;
  }
  Vec3 point;
  float gain = lamp.power;
  if (lamp.kind == kDisk) {
    const float rho = sqrtf(a), x = lamp.radius > 0 ? rho * cosf(2 * kPi * b) : 2 * a - 1,
                y = lamp.radius > 0 ? rho * sinf(2 * kPi * b) : 2 * b - 1;
    point = lamp.at + lamp.u * x + lamp.v * y;
  } else {
    const float z = 2 * a - 1, s = sqrtf(fmaxf(0, 1 - z * z));
    point = lamp.at + Vec3{s * cosf(2 * kPi * b), s * sinf(2 * kPi * b), z} * lamp.radius;
  }
  direction = point - p;
  const float squared = fmaxf(dot(direction, direction), 1e-6F);
  distance = sqrtf(squared);
  direction = direction * (1 / distance);
  if (lamp.kind == kDisk) gain *= fmaxf(0, -dot(direction, lamp.aim));
  if (lamp.kind == kSpot) {
    const float c = -dot(direction, lamp.aim);
    const float t = fminf(1, fmaxf(0, (c - lamp.cosOuter) / fmaxf(lamp.cosInner - lamp.cosOuter, 1e-5F)));
    gain *= t * t * (3 - 2 * t);
  }
  distance -= kOffset;
  return gain / squared;
}

/// Follows a pixel's paths: at every vertex it asks every lamp what arrives from it (Kajiya, "The rendering
/// equation", 1986). `light`: kLightFloats; `seen`: kSeenFloats, sums over the samples. Of a lamp that faces
/// away, both of `seen` are 0.
BOTH inline void tracePixel(const Scene& scene, int width, int height, int x, int y, float* light,
                            float* seen) {
  PathRandom random{hashOf(x, y, int(scene.seed))};
  float open[kMostLamps] = {}, direct[kMostLamps] = {};
  for (int i = 0; i < kLightFloats; ++i) light[i] = 0;
  for (int k = 0; k < scene.samples; ++k) {
    const float u = 2 * (x + random.next()) / width - 1, v = 1 - 2 * (y + random.next()) / height;
    Vec3 origin = scene.eye, direction = normalized(scene.forward + scene.right * u + scene.up * v);
    Vec3 weight{1, 1, 1};
    for (int bounce = 0; bounce <= scene.bounces; ++bounce) {
      Hit hit;
      if (!castRay(scene, origin, direction, hit)) break;
      const Vec3 p = origin + direction * hit.distance;
      const Solid& solid = scene.solids[hit.solid];
      const Material& material = scene.materials[solid.material];
      const Vec3 albedo = albedoAt(material, p, solid);
      const Vec3 n = shadingNormal(material, p, hit.normal);
      const Vec3 mirrored = direction - n * (2 * dot(direction, n));
      const Vec3 above = p + hit.normal * kOffset;
      for (int i = 0; i < scene.lampCount; ++i) {
        Vec3 to;
        float distance;
        const float arrives = sampleLamp(scene.lamps[i], p, random, to, distance);
        if (arrives <= 0) continue;
        const float flat = dot(hit.normal, to), cosine = dot(n, to);
        if (flat <= 0 && material.translucency <= 0) continue;
        const bool sees = flat > 0 ? !isBlocked(scene, above, to, distance) : false;
        if (bounce == 0 && flat > 0) {
          open[i] += arrives * flat;
          if (sees) direct[i] += arrives * flat;
        }
        Vec3 f{0, 0, 0};  // the share that the surface sends back along the path
        if (flat > 0 && sees && cosine > 0) {
          f = albedo * ((1 - material.translucency) * cosine / kPi);
          if (material.gloss > 0) {
            const float c = dot(mirrored, to);
            if (c > 0) {
              const float lobe =
                  material.gloss * (material.exponent + 2) / (2 * kPi) * powf(c, material.exponent) * cosine;
              f = f + Vec3{lobe, lobe, lobe};
            }
          }
        } else if (flat < 0 && material.translucency > 0 &&
                   !isBlocked(scene, p - hit.normal * kOffset, to, distance)) {
          f = albedo * (material.translucency * -flat / kPi);
        }
        light[i * 3] += weight.x * f.x * arrives;
        light[i * 3 + 1] += weight.y * f.y * arrives;
        light[i * 3 + 2] += weight.z * f.z * arrives;
      }
      // Go on as a mirror would, through the surface or back from it.
      if (random.next() < material.gloss && material.gloss > 0) {
        direction = directionAround(normalized(mirrored), powf(random.next(), 1 / (material.exponent + 1)),
                                    2 * kPi * random.next());
        if (dot(direction, hit.normal) <= 0) break;
        origin = above;
      } else {
        weight = weight * albedo;
        const bool passes = random.next() < material.translucency;
        direction = directionAround(passes ? n * -1 : n, sqrtf(random.next()), 2 * kPi * random.next());
        origin = passes ? p - hit.normal * kOffset : above;
      }
    }
  }
  for (int i = 0; i < scene.lampCount; ++i) {
    for (int c = 0; c < 3; ++c) light[i * 3 + c] /= scene.samples;
    seen[i * 2] = direct[i];
    seen[i * 2 + 1] = open[i];
  }
}

}  // namespace training
