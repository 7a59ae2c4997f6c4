#include "tests/train/props.h"

#include <algorithm>
#include <cmath>

namespace training {
namespace {

/// A crate, often with a smaller one on it.
void addCrates(Stage& stage, Vec3 at, float turn) {
  Dice& dice = stage.dice;
  const float h = dice.real(.3F, .6F);
  stage.add(kBox, at + Vec3{0, 0, h / 2}, {h / 2, h / 2, h / 2}, stage.material(.1F, .9F, .15F), turn);
  if (dice.chance(.5F))
    stage.add(kBox, at + Vec3{0, 0, 1.4F * h}, {.4F * h, .4F * h, .4F * h}, stage.material(.1F, .9F, .15F),
              turn + .4F);
}

}  // namespace

void addVessel(Stage& stage, Vec3 at, float height) {
  Dice& dice = stage.dice;
  const int m = stage.material(.08F, .9F, .08F, .5F);
  const float r = height * dice.real(.2F, .5F);
  switch (dice.whole(0, 6)) {
    case 0:
      stage.add(kSphere, at + Vec3{0, 0, r}, {r, r, r}, m);
      break;
    case 1:  // a bottle
      stage.add(kSphere, at + Vec3{0, 0, .35F * height}, {r, r, .35F * height}, m);
      stage.add(dice.chance(.5F) ? kTube : kCylinder, at + Vec3{0, 0, .8F * height},
                {.4F * r, .4F * r, .2F * height}, m, 0, {}, dice.real(-.6F, .5F));
      break;
    case 2:
      stage.add(kCylinder, at + Vec3{0, 0, .5F * height}, {r, r, .5F * height}, m, 0, {},
                dice.real(-.3F, .9F));
      break;
    case 3: {
      const float w = r * dice.real(.6F, 1.2F);
      stage.add(kBox, at + Vec3{0, 0, .5F * height}, {r, w, .5F * height}, m, dice.real(0, 3));
      if (dice.chance(.4F))
        stage.add(kBox, at + Vec3{0, 0, 1.2F * height}, {.7F * r, .7F * w, .2F * height},
                  stage.material(.1F, .9F, .1F), dice.real(0, 3));
      break;
    }
    case 4:  // a bowl with a fruit in it
      stage.add(kTube, at + Vec3{0, 0, .4F * height}, {r, r, .4F * height}, m, 0, {}, dice.real(-.4F, .4F));
      stage.add(kSphere, at + Vec3{0, 0, .5F * height}, {.7F * r, .7F * r, .5F * r},
                stage.material(.1F, .9F, .05F));
      break;
    case 5: {  // a rod that leans
      const Vec3 lean = normalized(Vec3{dice.real(-1, 1), dice.real(-1, 1), .6F});
      stage.rod(at + Vec3{0, 0, .15F * height}, at + Vec3{0, 0, .15F * height} + lean * (1.3F * height),
                r * dice.real(.1F, .5F), m, dice.real(0, .6F));
      break;
    }
    default:  // a glass on a stem
      stage.add(kCylinder, at + Vec3{0, 0, .05F * height}, {r, r, .05F * height}, m);
      stage.add(kCylinder, at + Vec3{0, 0, .4F * height}, {.12F * r, .12F * r, .35F * height}, m);
      stage.add(kSphere, at + Vec3{0, 0, .8F * height}, {r * .8F, r * .8F, .25F * height}, m);
  }
}

void addTable(Stage& stage, Vec3 at, float turn, float width, float depth, float height, float top,
              bool isChair) {
  Dice& dice = stage.dice;
  const int m = stage.material(.08F, .8F, .1F, .3F);
  const float c = std::cos(turn), s = std::sin(turn), leg = dice.real(.015F, .035F) * std::max(.5F, height);
  const auto place = [&](float x, float y, float z) { return at + Vec3{c * x - s * y, s * x + c * y, z}; };
  stage.add(kBox, place(0, 0, height - top / 2), {width / 2, depth / 2, top / 2}, m, turn);
  for (int i = 0; i < 4; ++i) {
    const float x = (i & 1 ? 1 : -1) * (width / 2 - leg), y = (i & 2 ? 1 : -1) * (depth / 2 - leg);
    if (dice.chance(.5F))
      stage.add(kBox, place(x, y, (height - top) / 2), {leg, leg, (height - top) / 2}, m, turn);
    else
      stage.add(kCylinder, place(x, y, (height - top) / 2), {leg, leg, (height - top) / 2}, m);
  }
  if (isChair) {
    const int slats = dice.whole(1, 5);
    for (int i = 0; i < 2; ++i)
      stage.add(kBox, place((i ? 1 : -1) * (width / 2 - leg), depth / 2 - leg, height * 1.45F),
                {leg, leg, height * .45F}, m, turn);
    for (int i = 0; i < slats; ++i)
      stage.add(kBox, place(0, depth / 2 - leg, height * (1.2F + .7F * (i + .5F) / slats)),
                {width / 2, leg * .7F, .2F * height / slats}, m, turn);
  }
}

void addShelf(Stage& stage, Vec3 at, float turn) {
  Dice& dice = stage.dice;
  const int m = stage.material(.1F, .8F, .1F);
  const float c = std::cos(turn), s = std::sin(turn), w = dice.real(.3F, .5F), h = dice.real(1, 1.9F),
              depth = .15F;
  for (int i = 0; i < 2; ++i)
    stage.add(kBox, at + Vec3{(i ? c : -c) * w, (i ? s : -s) * w, h / 2}, {.015F, depth, h / 2}, m, turn);
  const int count = dice.whole(3, 5);
  for (int i = 0; i < count; ++i) {
    stage.add(kBox, at + Vec3{0, 0, h * (i + .5F) / count}, {w, depth, .012F}, m, turn);
    if (dice.chance(.7F)) {
      const float x = dice.real(-.7F, .7F) * w;
      addVessel(stage, at + Vec3{c * x, s * x, h * (i + .5F) / count + .012F},
                dice.real(.4F, .8F) * h / count);
    }
  }
}

void addLadder(Stage& stage, Vec3 at, float turn) {
  Dice& dice = stage.dice;
  const int m = stage.material(.1F, .8F, .1F);
  const float c = std::cos(turn), s = std::sin(turn), w = .22F, h = dice.real(1.2F, 2),
              lean = dice.real(.2F, .4F);
  const Vec3 a = at + Vec3{c * w, s * w, 0}, b = at - Vec3{c * w, s * w, 0}, up{-s * lean, c * lean, h};
  stage.rod(a, a + up, .022F, m);
  stage.rod(b, b + up, .022F, m);
  for (int i = 1; i < 6; ++i) stage.rod(a + up * (i / 6.F), b + up * (i / 6.F), .014F, m);
}

void addShrub(Stage& stage, Vec3 at, float height, int leaves) {
  Dice& dice = stage.dice;
  const int bark = stage.material(.05F, .3F, .05F, 0),
            leaf = stage.material(.05F, .5F, .1F, .3F, dice.chance(.3F) ? .15F : 0);
  Vec3 p = at;
  for (int i = 0; i < 3; ++i) {
    const Vec3 q = p + Vec3{dice.real(-.12F, .12F) * height, dice.real(-.12F, .12F) * height, height / 3.3F};
    stage.rod(p, q, .02F * height * (3 - i) / 3 + .004F, bark, .2F);
    p = q;
  }
  for (int i = 0; i < leaves; ++i) {
    const Vec3 q = at + Vec3{dice.real(-.4F, .4F) * height, dice.real(-.4F, .4F) * height,
                             dice.real(.3F, 1.05F) * height};
    const float l = height * dice.real(.04F, .1F);
    stage.add(kSphere, q, {l, l * dice.real(.4F, .7F), .06F * l}, leaf, dice.real(0, 6),
              Vec3{dice.real(-1, 1), dice.real(-1, 1), dice.real(.2F, 1)});
  }
}

void addSlats(Stage& stage, Vec3 at, float turn, float lean, float width, float height, int count,
              bool crossed, bool across, float thickness) {
  const int m = stage.material(.08F, .9F, .1F, .2F);
  const float c = std::cos(turn), s = std::sin(turn);
  const Vec3 x{c, s, 0}, z = normalized(Vec3{-s * lean, c * lean, 1});
  const auto bar = [&](Vec3 a, Vec3 b) {
    const Vec3 mid = (a + b) * .5F, along = b - a;
    stage.add(kBox, mid, {thickness, thickness * 1.5F, .5F * std::sqrt(dot(along, along))}, m, 0, along);
  };
  for (int i = 0; i <= count; ++i) {
    const float t = float(i) / count;
    if (!across || crossed) bar(at + x * ((t - .5F) * width), at + x * ((t - .5F) * width) + z * height);
    if (across || crossed)
      bar(at - x * (width / 2) + z * (t * height), at + x * (width / 2) + z * (t * height));
  }
}

void addPerson(Stage& stage, Vec3 at, float height, float turn) {
  Dice& dice = stage.dice;
  const int skin = stage.material(.2F, .8F, .1F, .4F), cloth = stage.material(.05F, .8F, .1F, .1F),
            hair = stage.material(.03F, .4F, .03F, .2F);
  const float c = std::cos(turn), s = std::sin(turn);
  const auto place = [&](float x, float y, float z) { return at + Vec3{c * x - s * y, s * x + c * y, z}; };
  const Vec3 face = place(0, 0, .93F * height);
  stage.add(kSphere, face, {.052F * height, .062F * height, .072F * height}, skin, turn);
  stage.add(kSphere, place(0, -.062F * height, .925F * height),
            {.011F * height, .02F * height, .014F * height}, skin, turn);
  stage.add(kSphere, place(0, .012F * height, .945F * height), {.056F * height, .06F * height, .07F * height},
            hair, turn);
  stage.rod(place(0, 0, .82F * height), place(0, 0, .89F * height), .03F * height, skin);
  stage.add(kSphere, place(0, 0, .73F * height), {.125F * height, .07F * height, .12F * height}, cloth, turn);
  stage.add(kSphere, place(0, 0, .57F * height), {.1F * height, .07F * height, .13F * height}, cloth, turn);
  for (int i = 0; i < 2; ++i) {
    const float x = i ? 1.F : -1.F, swing = dice.real(-.15F, .15F);
    const Vec3 shoulder = place(x * .12F * height, 0, .79F * height),
               elbow = place(x * (.14F + dice.real(0, .1F)) * height, swing * height, .64F * height);
    stage.rod(shoulder, elbow, .03F * height, cloth, .2F);
    stage.add(kSphere, elbow, {.027F * height, .027F * height, .027F * height}, cloth);
    stage.rod(elbow,
              place(x * (.12F + dice.real(0, .15F)) * height, (swing - .1F) * height,
                    dice.real(.48F, .6F) * height),
              .024F * height, skin, .3F);
    stage.rod(place(x * .05F * height, 0, .5F * height), place(x * .07F * height, swing * .3F * height, 0),
              .045F * height, cloth, .4F);
  }
}

void addFurniture(Stage& stage, float x0, float x1, float y0, float y1, int count) {
  Dice& dice = stage.dice;
  for (int i = 0; i < count; ++i) {
    const Vec3 at{dice.real(x0, x1), dice.real(y0, y1), 0};
    const float turn = dice.real(0, 6);
    switch (dice.whole(0, 8)) {
      case 0:
        addTable(stage, at, turn, dice.real(.6F, 1.2F), dice.real(.4F, .7F), dice.real(.4F, .75F), .04F,
                 false);
        break;
      case 1:
        addTable(stage, at, turn, .42F, .42F, .45F, .04F, true);
        break;
      case 2:
        addShelf(stage, at, turn);
        break;
      case 3:
        addLadder(stage, at, turn);
        break;
      case 4:
        addShrub(stage, at, dice.real(.6F, 1.2F), dice.whole(12, 40));
        break;
      case 5:
        addVessel(stage, at, dice.real(.4F, 1));
        break;
      case 6:
        addSlats(stage, at, turn, 0, dice.real(.5F, 1), dice.real(.8F, 1.8F), dice.whole(4, 10),
                 dice.chance(.4F), dice.chance(.5F), dice.real(.01F, .03F));
        break;
      case 7:
        addCrates(stage, at, turn);
        break;
      default:
        stage.add(kCylinder, at + Vec3{0, 0, .5F}, {dice.real(.05F, .2F), dice.real(.05F, .2F), .5F},
                  stage.material(.1F, .9F, .15F), 0, {}, dice.real(-.2F, .4F));
    }
  }
}

void addWall(Stage& stage, bool alongX, float at, float from, float to, float height,
             const std::vector<Opening>& openings, int material, float thickness) {
  float cursor = from;
  const auto piece = [&](float a, float b, float z0, float z1) {
    if (alongX)
      stage.box(a, b, at - thickness / 2, at + thickness / 2, z0, z1, material);
    else
      stage.box(at - thickness / 2, at + thickness / 2, a, b, z0, z1, material);
  };
  for (const Opening& opening : openings) {
    piece(cursor, opening.from, 0, height);
    piece(opening.from, opening.to, 0, opening.bottom);
    piece(opening.from, opening.to, opening.top, height);
    cursor = opening.to;
  }
  piece(cursor, to, 0, height);
}

void addBars(Stage& stage, bool alongX, float at, const Opening& opening, int count, int material,
             float halfWidth) {
  Dice& dice = stage.dice;
  const auto bar = [&](float a, float b, float z0, float z1) {
    if (alongX)
      stage.box(a, b, at - halfWidth, at + halfWidth, z0, z1, material);
    else
      stage.box(at - halfWidth, at + halfWidth, a, b, z0, z1, material);
  };
  for (int i = 1; i <= count; ++i) {
    const float a = opening.from + (opening.to - opening.from) * i / (count + 1),
                z = opening.bottom + (opening.top - opening.bottom) * i / (count + 1);
    bar(a - halfWidth, a + halfWidth, opening.bottom, opening.top);
    if (dice.chance(.6F)) bar(opening.from, opening.to, z - halfWidth, z + halfWidth);
  }
}

}  // namespace training
