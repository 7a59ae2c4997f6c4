#pragma once

#include <initializer_list>
#include <random>

#include "tests/train/scene.h"
#include "tests/train/vec3.h"

namespace training {

/// Random choices for what is drawn. g++ evaluates the arguments of a call from the last to the first, and a
/// call here often throws the dice for several: another compiler draws other sets, as good ones.
struct Dice {
  std::mt19937 engine;

  float real(float from, float to);
  int whole(int from, int to);  ///< both ends may come
  bool chance(float probability);
  float sign();
  template <class T>
  T pick(std::initializer_list<T> choices) {
    return *(choices.begin() + whole(0, int(choices.size()) - 1));
  }
};

/// A scene while it is drawn, and where its things and lamps belong. Metres.
struct Stage {
  Dice dice;
  float aspect = .5625F;  ///< height of the picture over its width
  Scene scene{};
  Vec3 subject{0, 0, .6F};                        ///< what the lamps are for
  float extent = 1;                               ///< about half as wide as what the camera sees there
  Vec3 backdrop{0, 2, 1.2F};                      ///< the middle of the wall behind
  Vec3 lampsFrom{-5, -5, .1F}, lampsTo{5, 5, 5};  ///< corners of the box that lamps stay in
  float keySide = 1;                              ///< 1: the key comes from the right, -1: from the left

  /// Draws a material and returns its number. `dark` to `bright`: albedo; `scale`: of its pattern; `gloss`:
  /// probability that it is glossy.
  int material(float dark = .08F, float bright = .9F, float scale = .3F, float gloss = .35F,
               float translucency = 0);

  /// `half`: half lengths along the solid's axes; `turn`: radians about its z; `lean`: where its z points
  /// (all 0: up). Does nothing once the scene is full.
  void add(int shape, Vec3 at, Vec3 half, int material, float turn = 0, Vec3 lean = {0, 0, 0},
           float taper = 0);
  void rod(Vec3 from, Vec3 to, float radius, int material, float taper = 0);
  void box(float x0, float x1, float y0, float y1, float z0, float z1,
           int material);  ///< nothing if it is empty

  /// `lens`: focal length in millimetres on a picture 36 mm wide.
  void camera(Vec3 eye, Vec3 at, float lens);
};

}  // namespace training
