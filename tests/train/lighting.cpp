#include "tests/train/lighting.h"

#include <algorithm>
#include <cmath>

namespace training {
namespace {

/// About the subject: degrees from the camera's side towards the key's, and up.
Vec3 orbit(const Stage& stage, float azimuth, float elevation, float distance) {
  const float a = azimuth * kPi / 180, e = elevation * kPi / 180;
  return stage.subject +
         Vec3{stage.keySide * std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e)} * distance;
}

Vec3 inReach(const Stage& stage, Vec3 p) {
  return {std::clamp(p.x, stage.lampsFrom.x, stage.lampsTo.x),
          std::clamp(p.y, stage.lampsFrom.y, stage.lampsTo.y),
          std::clamp(p.z, stage.lampsFrom.z, stage.lampsTo.z)};
}

Vec3 nearSubject(Stage& stage, float amount) {
  Dice& dice = stage.dice;
  return stage.subject + Vec3{dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1)} * (amount * stage.extent);
}

float distanceOf(Vec3 a, Vec3 b) {
  return std::sqrt(dot(b - a, b - a));
}

Lamp& place(Stage& stage, LampKind kind, Vec3 at, Vec3 target) {
  Lamp& lamp = stage.scene.lamps[stage.scene.lampCount++];
  lamp = {};
  lamp.kind = kind;
  lamp.at = at;
  lamp.aim = normalized(target - at);
  lamp.power = 1;
  return lamp;
}

enum Fixture { kSpotlight, kBareBulb, kPanel };

/// A lamp that lights `cover` metres to either side of its target.
void addFixture(Stage& stage, int fixture, Vec3 at, Vec3 target, float cover) {
  Dice& dice = stage.dice;
  at = inReach(stage, at);
  const float far = distanceOf(at, target);
  if (fixture == kSpotlight) {
    addSpot(stage, at, target, far * dice.pick({.002F, .008F, .025F}),
            std::min(100.F, 2 * std::atan2(cover, far) * 180 / kPi), dice.pick({.03F, .08F, .2F, .6F}));
  } else if (fixture == kBareBulb) {
    place(stage, kPoint, at, target).radius = far * dice.pick({.002F, .008F, .02F});
  } else {
    const float e = far * dice.pick({.08F, .2F, .45F, .8F}) * dice.real(.8F, 1.25F);
    addDisk(stage, at, target, e, dice.chance(.6F) ? e * dice.real(.4F, 1.2F) : e, dice.chance(.4F));
  }
}

/// Beside the lens, or a large panel on the other side than the key.
void addFill(Stage& stage, float away) {
  Dice& dice = stage.dice;
  if (dice.chance(.3F)) {
    addDisk(stage, stage.scene.eye + Vec3{0, -.02F, dice.real(0, .1F)}, stage.subject, .1F, .1F, true);
    return;
  }
  const Vec3 at = inReach(stage, orbit(stage, -dice.real(20, 65), dice.real(8, 40), away));
  const float e = distanceOf(stage.subject, at) * dice.real(.25F, .9F);
  addDisk(stage, at, stage.subject, e, e * dice.real(.5F, 1.2F), false);
}

void addBackgroundLamp(Stage& stage) {
  Dice& dice = stage.dice;
  const float across = stage.extent * dice.real(.3F, 1.1F) * dice.sign();
  const Vec3 at = stage.backdrop +
                  Vec3{across, -stage.extent * dice.real(.35F, .8F), stage.extent * dice.real(-.5F, .9F)};
  addFixture(stage, dice.chance(.7F) ? kSpotlight : kBareBulb, at,
             stage.backdrop + Vec3{.3F * across * dice.real(-1, 1), 0, stage.extent * dice.real(-.1F, .3F)},
             stage.extent * dice.real(.4F, .9F));
}

void addGobo(Stage& stage) {
  Dice& dice = stage.dice;
  const Vec3 at =
      orbit(stage, dice.real(35, 85) * dice.sign(), dice.real(15, 45), stage.extent * dice.real(3, 4.5F));
  const Vec3 aim = normalized(stage.subject - at);
  const float far = distanceOf(at, stage.subject), t = dice.real(.3F, .5F), half = .75F * stage.extent * t;
  const Vec3 middle = at + aim * (far * t);
  const int m = stage.material(), bars = dice.whole(2, 6);
  const Vec3 x = normalized(cross(aim, Vec3{0, 0, 1})), z = cross(x, aim);
  const float thickness = half * dice.real(.02F, .1F);
  const bool crossed = dice.chance(.6F);
  for (int i = 0; i <= bars; ++i) {
    const float p = half * 1.15F * (2.F * i / bars - 1);
    stage.add(kBox, middle + x * p, {thickness, thickness, half * 1.15F}, m, 0, z);
    if (crossed || i == 0 || i == bars)
      stage.add(kBox, middle + z * p, {thickness, thickness, half * 1.15F}, m, 0, x);
  }
  addSpot(stage, at, stage.subject, far * dice.pick({.002F, .01F}), 2 * std::atan2(half, far * t) * 180 / kPi,
          .05F);
}

void addPractical(Stage& stage) {
  Dice& dice = stage.dice;
  const Vec3 at = inReach(stage, nearSubject(stage, .9F));
  const float r = stage.extent * dice.real(.06F, .16F);
  const int shade = stage.material(.3F, .8F, .2F, 0, dice.pick({.1F, .2F, .3F, 0.F}));
  if (dice.chance(.8F))
    stage.add(kTube, at, {r, r, r * dice.real(.6F, 1.1F)}, shade, 0, {}, dice.real(0, .5F));
  if (dice.chance(.7F)) stage.rod({at.x, at.y, 0}, at - Vec3{0, 0, .3F * r}, .06F * r, stage.material());
  place(stage, kPoint, at + Vec3{0, 0, .1F * r}, at - Vec3{0, 0, 1}).radius = .12F * r;
}

void addCeilingLamp(Stage& stage) {
  Dice& dice = stage.dice;
  const Vec3 at{stage.subject.x + dice.real(-1, 1) * stage.extent,
                stage.subject.y + dice.real(-.5F, 1) * stage.extent, stage.lampsTo.z - .05F};
  if (dice.chance(.5F))
    addSpot(stage, at, {at.x + dice.real(-.5F, .5F), at.y + dice.real(-.5F, .5F), 0}, .03F, dice.real(35, 90),
            dice.pick({.03F, .1F, .3F, .6F}));
  else
    addDisk(stage, at, at - Vec3{0, 0, 1}, stage.extent * dice.real(.2F, 1), stage.extent * dice.real(.2F, 1),
            false);
}

}  // namespace

void addDisk(Stage& stage, Vec3 at, Vec3 target, float u, float v, bool round) {
  Lamp& lamp = place(stage, kDisk, at, target);
  const Vec3 x = normalized(cross(lamp.aim, std::abs(lamp.aim.z) < .95F ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
  lamp.u = x * (u / 2);
  lamp.v = cross(lamp.aim, x) * (v / 2);
  lamp.radius = round ? 1 : 0;
}

void addSpot(Stage& stage, Vec3 at, Vec3 target, float radius, float degrees, float blend) {
  Lamp& lamp = place(stage, kSpot, at, target);
  lamp.radius = radius;
  lamp.cosOuter = std::cos(degrees * kPi / 360);
  lamp.cosInner = lamp.cosOuter + (1 - lamp.cosOuter) * blend;
}

void addSun(Stage& stage, Vec3 at, Vec3 target, float degrees) {
  Lamp& lamp = place(stage, kSun, at, target);
  lamp.cosOuter = std::cos(degrees * kPi / 360);
}

void addLamp(Stage& stage, LampRole role) {
  Dice& dice = stage.dice;
  const float extent = stage.extent, away = extent * dice.real(1.6F, 3.5F);
  switch (role) {
    case kKey:
      addFixture(stage, dice.whole(0, 2), orbit(stage, dice.real(25, 75), dice.real(18, 58), away),
                 nearSubject(stage, .15F), extent * dice.real(.6F, 1.3F));
      break;
    case kFill:
      addFill(stage, away);
      break;
    case kBack:
      addFixture(stage, dice.whole(0, 2),
                 orbit(stage, 180 + dice.real(-45, 45), dice.real(30, 60), extent * dice.real(1.5F, 2.5F)),
                 nearSubject(stage, .1F), extent * dice.real(.6F, 1.2F));
      break;
    case kKicker:
      addFixture(stage, dice.whole(0, 2),
                 orbit(stage, -dice.real(75, 135), dice.real(4, 30), extent * dice.real(1.6F, 3)),
                 nearSubject(stage, .2F), extent * dice.real(.5F, 1));
      break;
    case kBackground:
      addBackgroundLamp(stage);
      break;
    case kSunlight:
      addSun(stage, orbit(stage, dice.real(25, 80), dice.real(22, 60), 6 * extent), stage.subject,
             dice.pick({.53F, .53F, 1.5F, 5.F}));
      break;
    case kGobo:
      addGobo(stage);
      break;
    case kPractical:
      addPractical(stage);
      break;
    case kCeiling:
      addCeilingLamp(stage);
      break;
    case kSky:
      place(stage, kDome, {0, 0, 9}, {0, 0, 0});
  }
}

void addLamps(Stage& stage, std::vector<LampRole> menu, LampRole first) {
  const int count = stage.dice.whole(2, 5);
  std::vector<LampRole> chosen{first};
  std::shuffle(menu.begin(), menu.end(), stage.dice.engine);
  for (const LampRole role : menu)
    if (int(chosen.size()) < count && role != first) chosen.push_back(role);
  for (const LampRole role : chosen) addLamp(stage, role);
}

}  // namespace training
