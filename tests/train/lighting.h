#pragma once

#include <vector>

#include "tests/train/stage.h"
#include "tests/train/vec3.h"

// Lamps for a stage. Angles in degrees, the rest in metres.
namespace training {

/// What a lamp is for, and so where it stands.
enum LampRole {
  kKey,
  kFill,
  kBack,
  kKicker,      // from the side that the key is not on
  kBackground,  // on the backdrop only
  kSunlight,
  kGobo,       // a spot through a lattice that stands out of the picture
  kPractical,  // a lamp in the picture, with a shade open above and below, or bare
  kCeiling,
  kSky
};

/// A rectangle of u x v, or an ellipse if `round`, that shines to one side.
void addDisk(Stage& stage, Vec3 at, Vec3 target, float u, float v, bool round);

/// `degrees`: of the cone; `blend`: share of it that fades.
void addSpot(Stage& stage, Vec3 at, Vec3 target, float radius, float degrees, float blend);

/// `degrees`: of the sun's disk.
void addSun(Stage& stage, Vec3 at, Vec3 target, float degrees);

void addLamp(Stage& stage, LampRole role);

/// Two to five lamps: `first`, and others of the menu.
void addLamps(Stage& stage, std::vector<LampRole> menu, LampRole first);

}  // namespace training
