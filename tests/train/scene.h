#pragma once

#include <cstdint>

#include "tests/train/vec3.h"

namespace training {

constexpr int kMostLamps = 5, kMostSolids = 256, kMostMaterials = 32;

/// Cylinders and tubes (open at both ends) stand along their z; their radius is 1 below and 1 - taper above.
enum Shape { kBox, kSphere, kCylinder, kTube };

struct Solid {
  Vec3 at;                      // centre
  Vec3 localX, localY, localZ;  // axes over their half lengths: what brings a point to -1 .. 1
  float taper, bound;           // bound: radius of a sphere about all of it
  int shape, material;
};

enum Pattern { kPlain, kChecker, kStripes, kBricks, kClouds, kGrain };

struct Material {
  Vec3 one, other;        // the colours (albedo) that the pattern mixes
  float scale;            // metres: of the pattern
  float gloss, exponent;  // how much is reflected as a mirror would, and the width of that lobe (Phong)
  float relief;           // how much the normal follows noise
  float translucency;     // share of the light that goes through and leaves on the other side
  int pattern;
};

enum LampKind { kDisk, kPoint, kSpot, kSun, kDome };

struct Lamp {
  Vec3 at, aim, u, v;        // aim: unit; u, v: half extents of a disk
  float radius;              // metres of a point or spot; of a disk: above 0 round, else a rectangle
  float cosOuter, cosInner;  // half angles of the cone of a spot; outer: of a sun's disk
  float power;
  int kind;
};

struct Scene {
  Solid solids[kMostSolids];
  Material materials[kMostMaterials];
  Lamp lamps[kMostLamps];
  int solidCount, materialCount, lampCount, bounces, samples;
  Vec3 eye, right, up, forward;  // right and up: half extents of the picture at distance 1
  uint32_t seed;
};

}  // namespace training
