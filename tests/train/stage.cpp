#include "tests/train/stage.h"

#include <algorithm>
#include <cmath>

namespace training {

float Dice::real(float from, float to) {
  return from + (to - from) * std::uniform_real_distribution<float>()(engine);
}

int Dice::whole(int from, int to) {
  return std::uniform_int_distribution<int>(from, to)(engine);
}

bool Dice::chance(float probability) {
  return real(0, 1) < probability;
}

float Dice::sign() {
  return chance(.5F) ? 1.F : -1.F;
}

int Stage::material(float dark, float bright, float scale, float gloss, float translucency) {
  if (scene.materialCount == kMostMaterials) return dice.whole(0, kMostMaterials - 1);
  Material& m = scene.materials[scene.materialCount];
  const float level = dice.real(dark, bright),
              vivid = dice.chance(.4F) ? dice.real(.3F, .95F) : dice.real(0, .25F);
  const auto colour = [&](float brightest) {
    const float hue = dice.real(0, 2 * kPi);
    const Vec3 c{1 + vivid * std::cos(hue), 1 + vivid * std::cos(hue - 2.1F),
                 1 + vivid * std::cos(hue + 2.1F)};
    const float most = std::max({c.x, c.y, c.z});
    return c * (brightest / most);
  };
  m.one = colour(level);
  m.other = colour(dice.chance(.6F) ? std::min(.95F, level * dice.real(.6F, 1.4F)) : dice.real(dark, bright));
  m.pattern = dice.pick({kPlain, kPlain, kChecker, kStripes, kBricks, kClouds, kClouds, kGrain});
  m.scale = scale * dice.real(.4F, 1.6F);
  m.gloss = dice.chance(gloss) ? dice.real(.02F, .15F) : dice.chance(.03F) ? .6F : 0;
  m.exponent = std::exp(dice.real(2, 6));
  m.relief = dice.chance(.2F) ? dice.real(.05F, .5F) : 0;
  m.translucency = translucency;
  return scene.materialCount++;
}

void Stage::add(int shape, Vec3 at, Vec3 half, int material, float turn, Vec3 lean, float taper) {
  if (scene.solidCount == kMostSolids) return;
  Solid& solid = scene.solids[scene.solidCount++];
  Vec3 x{std::cos(turn), std::sin(turn), 0}, y{-std::sin(turn), std::cos(turn), 0}, z{0, 0, 1};
  if (lean.x != 0 || lean.y != 0 || lean.z != 0) {
    z = normalized(lean);
    x = normalized(cross(std::abs(z.x) < .9F ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, z));
    y = cross(z, x);
    const Vec3 turned = x * std::cos(turn) + y * std::sin(turn);
    y = y * std::cos(turn) - x * std::sin(turn);
    x = turned;
  }
  half = {std::max(half.x, 1e-4F), std::max(half.y, 1e-4F), std::max(half.z, 1e-4F)};
  solid.at = at;
  solid.localX = x * (1 / half.x);
  solid.localY = y * (1 / half.y);
  solid.localZ = z * (1 / half.z);
  solid.taper = taper;
  solid.bound = std::sqrt(dot(half, half)) * (shape == kSphere ? 1 : 1.0001F) * (taper < 0 ? 1 - taper : 1);
  solid.shape = shape;
  solid.material = material;
}

void Stage::rod(Vec3 from, Vec3 to, float radius, int material, float taper) {
  const Vec3 along = to - from;
  add(kCylinder, (from + to) * .5F, {radius, radius, .5F * std::sqrt(dot(along, along))}, material, 0, along,
      taper);
}

void Stage::box(float x0, float x1, float y0, float y1, float z0, float z1, int material) {
  if (x1 > x0 && y1 > y0 && z1 > z0)
    add(kBox, {(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2}, {(x1 - x0) / 2, (y1 - y0) / 2, (z1 - z0) / 2},
        material);
}

void Stage::camera(Vec3 eye, Vec3 at, float lens) {
  scene.eye = eye;
  scene.forward = normalized(at - eye);
  const Vec3 right = normalized(cross(scene.forward, Vec3{0, 0, 1}));
  const float half = 18 / lens;
  scene.right = right * half;
  scene.up = cross(right, scene.forward) * (half * aspect);
}

}  // namespace training
