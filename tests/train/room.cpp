#include "tests/train/room.h"

#include <vector>

#include "tests/train/lighting.h"
#include "tests/train/props.h"

namespace training {
namespace {

/// The sun, a large panel or a spot that shines through an opening of the wall on the other side than the
/// key.
void addLampOutside(Stage& stage, const Opening& o, float halfWidth) {
  Dice& dice = stage.dice;
  const Vec3 mid{-stage.keySide * halfWidth, (o.from + o.to) / 2, (o.bottom + o.top) / 2};
  const Vec3 lands = {stage.keySide * dice.real(-.5F, .8F) * halfWidth * .5F, mid.y + dice.real(-.6F, .8F),
                      0};
  const Vec3 at = mid + normalized(mid - lands) * 6;
  if (dice.chance(.5F))
    addSun(stage, at, lands, dice.pick({.53F, .53F, 1.5F, 3.F}));
  else if (dice.chance(.5F))
    addDisk(stage, {mid.x - 1.6F * stage.keySide, mid.y, mid.z + .5F}, {stage.keySide * 2, mid.y, .3F},
            1.8F * (o.to - o.from), 1.8F * (o.top - o.bottom), false);
  else
    addSpot(stage, mid + normalized(mid - lands) * dice.real(2, 3.5F), mid, dice.pick({.01F, .06F}),
            dice.real(30, 60), .1F);
}

}  // namespace

void drawRoom(Stage& stage, bool corridor) {
  Dice& dice = stage.dice;
  stage.keySide = dice.sign();
  const float half = corridor ? dice.real(.95F, 1.4F) : dice.real(1.7F, 2.5F),
              deep = corridor ? dice.real(4, 8) : dice.real(1.8F, 2.8F), h = dice.real(2.4F, 3);
  stage.camera({stage.keySide * dice.real(-.3F, .7F) * half * .4F, corridor ? -1.6F : -dice.real(2.3F, 3.1F),
                dice.real(1, 1.8F)},
               {-stage.keySide * dice.real(0, .35F), corridor ? 2.6F : .9F, dice.real(.7F, 1.1F)},
               dice.real(22, 32));
  stage.subject = {0, corridor ? 2.2F : .8F, .6F};
  stage.extent = 1.15F;
  stage.backdrop = {0, deep, 1.2F};
  stage.lampsFrom = {-half + .15F, -2.6F, .15F};
  stage.lampsTo = {half - .15F, deep - .2F, h - .1F};
  stage.box(-9, 9, -9, 12, -.1F, 0, stage.material(.1F, .8F, .35F, .3F));
  const int paint = stage.material(.2F, .9F, .4F, .1F);
  addWall(stage, true, deep + .07F, -half - .14F, half + .14F, h, {}, paint, .14F);
  addWall(stage, false, stage.keySide * (half + .07F), -3.3F, deep, h, {},
          dice.chance(.5F) ? paint : stage.material(.2F, .9F, .4F, .1F), .14F);
  std::vector<Opening> openings;
  if (corridor)
    for (float y = dice.real(.2F, .9F); y < deep - 1.2F; y += dice.real(1.5F, 2.1F))
      openings.push_back({y, y + dice.real(.5F, .95F), dice.pick({0.F, .8F}), dice.real(1.9F, 2.2F)});
  else
    openings.push_back(
        {dice.real(-.4F, .3F), dice.real(.8F, 1.4F), dice.real(.5F, 1), h - dice.real(.3F, .7F)});
  addWall(stage, false, -stage.keySide * (half + .07F), -3.3F, deep, h, openings, paint, .14F);
  for (const Opening& o : openings)
    if (dice.chance(.7F))
      addBars(stage, false, -stage.keySide * (half + .07F), o, dice.whole(1, 3),
              stage.material(.1F, .9F, .1F), .02F);
  const bool outside = dice.chance(.6F);
  if (outside || dice.chance(.5F))
    stage.box(-half - .2F, half + .2F, -3.4F, deep + .2F, h, h + .1F, stage.material(.4F, .9F, .3F, 0));
  else
    stage.lampsTo.z = h + .8F;
  addFurniture(stage, -half + .3F, half - .3F, corridor ? .8F : -.4F, deep - .4F, dice.whole(3, 6));
  if (dice.chance(.3F))
    addPerson(stage, {dice.real(-.6F, .6F), dice.real(.2F, deep - .5F), 0}, 1.75F, dice.real(-1, 1));
  if (dice.chance(.4F))
    for (float y = .5F; y < deep; y += dice.real(1.2F, 1.8F))
      stage.box(stage.keySide * (half - .14F) - .07F, stage.keySide * (half - .14F) + .07F, y, y + .25F, 0, h,
                paint);
  if (!outside) {
    addLamps(stage, {kKey, kFill, kBack, kKicker, kBackground, kPractical, kCeiling}, kKey);
    return;
  }
  addLampOutside(stage, openings[size_t(dice.whole(0, int(openings.size()) - 1))], half);
  const int more = dice.whole(1, 4);
  for (int i = 0; i < more; ++i)
    addLamp(stage, dice.pick({kKey, kFill, kKicker, kBackground, kPractical, kCeiling}));
}

}  // namespace training
