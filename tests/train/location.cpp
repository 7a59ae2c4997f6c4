#include "tests/train/location.h"

#include <algorithm>
#include <cmath>

#include "tests/train/lighting.h"
#include "tests/train/props.h"
#include "tests/train/room.h"
#include "tests/train/stage.h"

namespace training {
namespace {

void drawTabletop(Stage& stage) {
  Dice& dice = stage.dice;
  stage.keySide = dice.sign();
  const float up = dice.real(.2F, .63F), turn = dice.real(-.3F, .3F), away = dice.real(.9F, 1.25F),
              deep = dice.real(.4F, .8F);
  const Vec3 at{0, .02F, .09F};
  stage.camera({away * std::sin(turn) * std::cos(up), -away * std::cos(turn) * std::cos(up),
                at.z + away * std::sin(up)},
               at, dice.real(38, 58));
  stage.subject = {0, .05F, .08F};
  stage.extent = .42F;
  stage.backdrop = {0, deep, .25F};
  stage.lampsFrom = {-5, -5, .04F};
  stage.lampsTo = {5, deep - .06F, 5};
  stage.box(-3, 3, -3, 3, -.05F, 0, stage.material(.1F, .85F, .08F, .35F));
  if (dice.chance(.8F)) stage.box(-3, 3, deep, deep + .1F, 0, 2.5F, stage.material(.15F, .9F, .15F, .1F));
  const int count = dice.whole(4, 12);
  for (int i = 0; i < count; ++i)
    addVessel(stage, {dice.real(-.42F, .42F), dice.real(-.24F, deep - .12F), 0}, dice.real(.05F, .24F));
  addLamps(stage, {kKey, kFill, kBack, kKicker, kBackground, kSunlight, kGobo, kPractical, kSky},
           dice.pick({kKey, kKey, kSunlight, kGobo}));
}

void drawStreet(Stage& stage) {
  Dice& dice = stage.dice;
  stage.keySide = dice.sign();
  const float deep = dice.real(2.2F, 3.4F), corner = dice.real(2, 3);
  stage.camera({stage.keySide * dice.real(-.2F, 1), -dice.real(3.5F, 5), dice.real(1.2F, 2.4F)},
               {-stage.keySide * dice.real(0, .3F), 1, dice.real(.8F, 1.3F)}, dice.real(24, 36));
  stage.subject = {0, .9F, .8F};
  stage.extent = 1.6F;
  stage.backdrop = {0, deep, 1.5F};
  stage.lampsFrom = {-7, -5, .15F};
  stage.lampsTo = {7, deep - .3F, 6};
  stage.box(-30, 30, -30, 30, -.1F, 0, stage.material(.1F, .6F, .3F, .2F));
  const float door = dice.real(-1, 1);
  addWall(stage, true, deep + .15F, -9, 9, dice.real(2.5F, 5), {{door - .45F, door + .45F, .0F, 2.2F}},
          stage.material(.2F, .85F, .2F, .05F), .3F);
  stage.box(door - .45F, door + .45F, deep + .2F, deep + .25F, 0, 2.2F, stage.material());
  if (dice.chance(.7F))
    addWall(stage, false, -stage.keySide * (corner + .15F), dice.real(-1, .6F), deep, dice.real(2, 4.5F), {},
            stage.material(.2F, .85F, .2F, .05F), .3F);
  if (dice.chance(.5F)) {
    const int trim = stage.material(.3F, .9F), steps = dice.whole(2, 4);
    for (int i = 0; i < steps; ++i)
      stage.box(door - .7F, door + .7F, deep - .28F * (steps - i), deep, .15F * i, .15F * (i + 1), trim);
  }
  const int posts = dice.whole(1, 5), m = stage.material();
  for (int i = 0; i < posts; ++i) {
    const Vec3 at{dice.real(-2, 2), dice.real(-1, deep - .4F), 0};
    const float h = dice.real(.7F, 2.4F), r = dice.real(.03F, .12F);
    stage.rod(at, at + Vec3{0, 0, h}, r, m);
    if (dice.chance(.6F)) stage.add(kSphere, at + Vec3{0, 0, h + r}, {1.4F * r, 1.4F * r, 1.4F * r}, m);
  }
  addFurniture(stage, -2, 2, -.8F, deep - .5F, dice.whole(1, 4));
  if (dice.chance(.4F))
    addPerson(stage, {dice.real(-1, 1), dice.real(-.5F, deep - .6F), 0}, 1.75F, dice.real(-1, 1));
  if (dice.chance(.5F)) {
    const float x = dice.real(-1.5F, 1.5F), z = dice.real(2, 2.8F);
    stage.rod({x, deep, z}, {x, deep - .75F, z}, .02F, m);
    stage.add(kBox, {x, deep - .42F, z - .3F}, {.02F, .27F, .22F}, stage.material());
  }
  if (dice.chance(.3F)) {
    const float z = dice.real(1, 1.6F);
    for (int i = 0; i < 3; ++i)
      stage.rod({-3, deep - 1 - .2F * i, z + .4F * i}, {3, deep - 1 - .2F * i, z + .4F * i}, .012F, m);
  }
  addLamps(stage, {kKey, kFill, kKicker, kBackground, kSunlight, kGobo, kPractical, kSky},
           dice.pick({kSunlight, kSunlight, kKey}));
}

void drawFigure(Stage& stage) {
  Dice& dice = stage.dice;
  stage.keySide = dice.sign();
  const float deep = dice.real(.8F, 2.4F);
  const bool whole = dice.chance(.45F);
  if (whole) {
    stage.camera({dice.real(-.7F, .7F), -dice.real(3.3F, 4.1F), dice.real(.9F, 1.7F)}, {0, .2F, .93F},
                 dice.real(32, 40));
    stage.subject = {0, 0, 1};
    stage.extent = 1;
  } else {
    stage.camera({dice.real(-.5F, .5F), -dice.real(1.5F, 2.1F), dice.real(1.4F, 1.65F)}, {0, 0, 1.5F},
                 dice.real(45, 64));
    stage.subject = {0, 0, 1.5F};
    stage.extent = .48F;
  }
  stage.backdrop = {0, deep, stage.subject.z};
  stage.lampsFrom = {-6, -6, .1F};
  stage.lampsTo = {6, deep - .15F, 4};
  stage.box(-9, 9, -9, 9, -.1F, 0, stage.material(.1F, .8F, .3F));
  stage.box(-6, 6, deep, deep + .1F, 0, 4, stage.material(.08F, .85F, .3F, .05F));
  if (dice.chance(.3F)) {
    const int m = stage.material();
    for (float x = -2.4F; x < 2.5F; x += .8F) stage.box(x - .25F, x + .25F, deep - .05F, deep, .2F, 2.8F, m);
  }
  addPerson(stage, {dice.real(-.15F, .15F), 0, 0}, dice.real(1.6F, 1.85F), dice.real(-.7F, .7F));
  if (dice.chance(.3F))
    addPerson(stage, {dice.sign() * dice.real(.4F, .7F), dice.real(-.2F, .6F), 0}, dice.real(1.5F, 1.85F),
              dice.real(-.7F, .7F));
  if (whole)
    addFurniture(stage, -1.5F, 1.5F, -.2F, deep - .2F, dice.whole(1, 3));
  else if (dice.chance(.6F)) {
    const float x = dice.sign() * dice.real(.35F, .55F);
    if (dice.chance(.4F))
      addShrub(stage, {x, .2F, 1}, .8F, 40);
    else if (dice.chance(.5F)) {
      stage.add(kCylinder, {x, .2F, .65F}, {.12F, .12F, .65F}, stage.material());
      addVessel(stage, {x, .2F, 1.3F}, .3F);
    } else
      addSlats(stage, {x, .3F, 0}, dice.real(-.4F, .4F), 0, .5F, 1.9F, dice.whole(6, 12), dice.chance(.5F),
               true, .012F);
  }
  addLamps(stage, {kKey, kFill, kBack, kKicker, kBackground, kGobo, kPractical},
           dice.pick({kKey, kKey, kGobo}));
}

void drawFoliage(Stage& stage) {
  Dice& dice = stage.dice;
  stage.keySide = dice.sign();
  const float deep = dice.real(1.2F, 2.2F);
  stage.camera({dice.real(-.6F, .6F), -dice.real(2.5F, 3.2F), dice.real(1, 1.6F)}, {0, .5F, .85F},
               dice.real(30, 42));
  stage.subject = {0, .6F, .85F};
  stage.extent = 1.05F;
  stage.backdrop = {0, deep, 1.1F};
  stage.lampsFrom = {-6, -6, .15F};
  stage.lampsTo = {6, deep - .2F, 4.5F};
  stage.box(-15, 15, -15, 15, -.1F, 0, stage.material(.12F, .75F, .25F, .2F));
  if (dice.chance(.85F)) stage.box(-8, 8, deep, deep + .16F, 0, 3.6F, stage.material(.2F, .9F, .25F, .05F));
  const int count = dice.whole(1, 3);
  for (int i = 0; i < count; ++i)
    addSlats(stage, {dice.real(-1.2F, 1.2F), dice.real(.2F, deep - .2F), 0}, dice.real(-.6F, .6F),
             -dice.pick({0.F, 0.F, .14F}), dice.real(.6F, 1.2F), dice.real(1, 2), dice.whole(4, 9),
             dice.chance(.6F), dice.chance(.6F), dice.real(.008F, .03F));
  const int shrubs = dice.whole(1, 3);
  for (int i = 0; i < shrubs; ++i)
    addShrub(stage, {dice.real(-1.3F, 1.3F), dice.real(-.3F, deep - .4F), dice.chance(.2F) ? 1.2F : 0.F},
             dice.real(.6F, 1.4F), dice.whole(20, 50));
  addFurniture(stage, -1.3F, 1.3F, -.2F, deep - .5F, dice.whole(0, 2));
  addLamps(stage, {kKey, kFill, kBack, kKicker, kBackground, kSunlight, kGobo, kPractical, kSky},
           dice.pick({kKey, kSunlight, kSunlight, kGobo}));
}

/// Spheres, boxes and columns on a plain: nothing in particular.
void drawHeap(Stage& stage) {
  Dice& dice = stage.dice;
  stage.keySide = dice.sign();
  const float deep = dice.real(1, 5);
  stage.camera({dice.real(-1, 1), -dice.real(2.5F, 4), dice.real(.5F, 3)}, {0, .5F, dice.real(.2F, .8F)},
               dice.real(24, 45));
  stage.subject = {0, .5F, .4F};
  stage.extent = 1.2F;
  stage.backdrop = {0, deep, 1};
  stage.lampsFrom = {-6, -6, .1F};
  stage.lampsTo = {6, deep - .1F, 5};
  stage.box(-20, 20, -20, 20, -.1F, 0, stage.material());
  if (dice.chance(.6F)) stage.box(-9, 9, deep, deep + .1F, 0, dice.real(1, 5), stage.material());
  if (dice.chance(.3F))
    stage.box(-stage.keySide * 2.2F - .1F, -stage.keySide * 2.2F, -4, 9, 0, dice.real(1, 5),
              stage.material());
  const int count = dice.whole(3, 16);
  for (int i = 0; i < count; ++i) {
    const float r = dice.real(.08F, .45F);
    const Vec3 at{dice.real(-1.6F, 1.6F), dice.real(-.8F, std::min(deep, 3.F)), 0};
    const int m = stage.material();
    switch (dice.whole(0, 3)) {
      case 0:
        stage.add(kSphere, at + Vec3{0, 0, dice.chance(.8F) ? r : dice.real(r, 1.5F)}, {r, r, r}, m);
        break;
      case 1:
        stage.add(kBox, at + Vec3{0, 0, r}, {r * dice.real(.3F, 1), r * dice.real(.3F, 1), r}, m,
                  dice.real(0, 3));
        break;
      case 2:
        stage.add(kCylinder, at + Vec3{0, 0, dice.real(.2F, 1)}, {r * .5F, r * .5F, dice.real(.2F, 1)}, m, 0,
                  {}, dice.real(-.3F, 1));
        break;
      default:
        stage.add(kBox, at + Vec3{0, 0, dice.real(.2F, 1.2F)},
                  {r * dice.real(.1F, 1), r * dice.real(.1F, 1), r * dice.real(.1F, 2)}, m, 0,
                  {dice.real(-1, 1), dice.real(-1, 1), dice.real(.1F, 1)});
    }
  }
  addLamps(stage, {kKey, kFill, kBack, kKicker, kBackground, kSunlight, kGobo, kPractical, kSky},
           static_cast<LampRole>(dice.whole(kKey, kSunlight)));
}

}  // namespace

Scene drawScene(uint32_t seed, float aspect) {
  Stage stage;
  stage.dice.engine.seed(seed * 7919U + 17U);
  stage.aspect = aspect;
  switch (seed % 8) {
    case 1:
      drawTabletop(stage);
      break;
    case 2:
      drawStreet(stage);
      break;
    case 3:
      drawFigure(stage);
      break;
    case 4:
      drawRoom(stage, true);
      break;
    case 5:
      drawFoliage(stage);
      break;
    case 6:
      drawHeap(stage);
      break;
    default:
      drawRoom(stage, false);
  }
  stage.scene.bounces = stage.dice.whole(2, 5);
  stage.scene.samples = stage.dice.pick({64, 128, 256});
  stage.scene.seed = seed;
  return stage.scene;
}

}  // namespace training
