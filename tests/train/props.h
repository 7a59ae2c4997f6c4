#pragma once

#include <vector>

#include "tests/train/stage.h"
#include "tests/train/vec3.h"

// Things that stand in a scene. `at` is where they stand, in metres; `turn`: radians about the vertical.
namespace training {

void addVessel(Stage& stage, Vec3 at, float height);
void addTable(Stage& stage, Vec3 at, float turn, float width, float depth, float height, float top,
              bool isChair);
void addShelf(Stage& stage, Vec3 at, float turn);
void addLadder(Stage& stage, Vec3 at, float turn);
void addShrub(Stage& stage, Vec3 at, float height, int leaves);

/// A lattice of bars: upright ones, or `across`, or both ways if `crossed`. `lean`: how far it leans back
/// over its height.
void addSlats(Stage& stage, Vec3 at, float turn, float lean, float width, float height, int count,
              bool crossed, bool across, float thickness);

void addPerson(Stage& stage, Vec3 at, float height, float turn);

/// Some of all that, on the floor between x0 and x1, y0 and y1.
void addFurniture(Stage& stage, float x0, float x1, float y0, float y1, int count);

/// A hole in a wall: along it, and above the floor.
struct Opening {
  float from, to, bottom, top;
};

/// A wall along x, or along y, which stands at `at` of the other axis; openings in the order of their `from`.
void addWall(Stage& stage, bool alongX, float at, float from, float to, float height,
             const std::vector<Opening>& openings, int material, float thickness);

/// Bars in an opening of such a wall.
void addBars(Stage& stage, bool alongX, float at, const Opening& opening, int count, int material,
             float halfWidth);

}  // namespace training
