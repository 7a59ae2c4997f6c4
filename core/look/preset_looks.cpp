#include "core/look/look.h"

namespace swaplight {
namespace {

using Level = RoleLook::Level;

LightColor white() {
  return {};
}

LightColor kelvin(float temperature) {
  LightColor color;
  color.kind = LightColor::Kind::Kelvin;
  color.kelvin = temperature;
  return color;
}

/// degrees 0..360, saturation and value 0..1
LightColor hue(float degrees, float saturation, float value = 1) {
  LightColor color;
  color.kind = LightColor::Kind::Hsv;
  color.value = Rgb(degrees / 360, saturation, value);
  return color;
}

RoleLook at(float stops, const LightColor& color) {
  return {Level::AsPhotographed, stops, color};
}
RoleLook overKey(float stops, const LightColor& color) {
  return {Level::OverKey, stops, color};
}
RoleLook off() {
  return {Level::Off, 0, {}};
}

}  // namespace

const std::vector<Look>& presetLooks() {
  // name, words, key, fill, back, practical, others, ambient
  static const std::vector<Look> looks{
      {"High key", "Bright and even: key to fill 2:1.", at(0.5F, white()), overKey(-1, white()),
       overKey(0, white()), at(0, kelvin(4300)), at(0, white()), 1},
      {"Low key", "Dark, one light carves: key to fill 16:1.", at(0, kelvin(5000)), overKey(-4, kelvin(6500)),
       overKey(-1, kelvin(5600)), at(-1, kelvin(2700)), at(-3, white()), 0.2F},
      {"Rembrandt", "A warm key, a soft shadow side: key to fill 4:1.", at(0, kelvin(3800)),
       overKey(-2, kelvin(4800)), overKey(-2, kelvin(4300)), at(-1, kelvin(2700)), at(-2, kelvin(3800)),
       0.4F},
      {"Silhouette", "Only light from behind.", at(-7, white()), off(), at(1, kelvin(6500)),
       at(-3, kelvin(3200)), at(-1, white()), 0.05F, at(1, kelvin(6500))},
      {"Day for night", "Daylight printed down and blue.", at(-2, hue(215, 0.55F)),
       overKey(-2.5F, hue(225, 0.6F)), overKey(0, hue(210, 0.45F)), at(-0.5F, kelvin(2400)),
       at(-3, hue(220, 0.6F)), 0.2F},
      {"Cool morning", "Sky before the sun, a hint of warmth from behind.", at(-0.5F, kelvin(8500)),
       overKey(-1, kelvin(11000)), overKey(0, kelvin(4800)), at(-1, kelvin(3000)), at(-0.5F, kelvin(9000)),
       0.8F},
      {"Golden hour", "A low warm sun against a blue sky.", at(0.7F, kelvin(2700)),
       overKey(-2.5F, kelvin(9500)), overKey(0, kelvin(3000)), at(-1, kelvin(2700)), at(-1, kelvin(5000)),
       0.6F},
      {"Moonlight", "Cold light from above, a lamp or two left on.", at(-2, kelvin(14000)),
       overKey(-3.5F, kelvin(20000)), overKey(1, kelvin(12000)), at(-0.5F, kelvin(2200)),
       at(-4, kelvin(14000)), 0.1F},
      {"Candle", "One small flame's colour, dark around it.", at(-0.7F, kelvin(1900)),
       overKey(-3, kelvin(1900)), overKey(-4, kelvin(2400)), at(0.5F, kelvin(1900)), at(-4, kelvin(2000)),
       0.1F},
      {"Neon", "Magenta against cyan, violet from behind.", at(0.3F, hue(320, 0.75F)),
       overKey(-0.7F, hue(190, 0.8F)), overKey(0, hue(265, 0.7F)), at(-1, hue(30, 0.6F)),
       at(-1, hue(280, 0.7F)), 0.2F},
  };
  return looks;
}

}  // namespace swaplight
