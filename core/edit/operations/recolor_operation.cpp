#include "core/edit/operations/recolor_operation.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

namespace swaplight {
namespace {

/// Rec.709's; other primaries' hues turn a little differently, grey stays grey in all.
float luminanceOf(const Rgb& color) {
  return 0.2126F * color.r + 0.7152F * color.g + 0.0722F * color.b;
}

// Oklab (Ottosson 2020): lightness and two opponent colours, in which turning a hue keeps how light and how
// colourful it looks. The root of a multiple is a multiple of the root: exposure does not matter.

Rgb oklabFromLinear(const Rgb& c) {
  const float l = std::cbrt(0.4122214708F * c.r + 0.5363325363F * c.g + 0.0514459929F * c.b);
  const float m = std::cbrt(0.2119034982F * c.r + 0.6806995451F * c.g + 0.1073969566F * c.b);
  const float s = std::cbrt(0.0883024619F * c.r + 0.2817188376F * c.g + 0.6299787005F * c.b);
  return {0.2104542553F * l + 0.7936177850F * m - 0.0040720468F * s,
          1.9779984951F * l - 2.4285922050F * m + 0.4505937099F * s,
          0.0259040371F * l + 0.7827717662F * m - 0.8086757660F * s};
}

Rgb linearFromOklab(const Rgb& lab) {
  const float l = lab.x + 0.3963377774F * lab.y + 0.2158037573F * lab.z;
  const float m = lab.x - 0.1055613458F * lab.y - 0.0638541728F * lab.z;
  const float s = lab.x - 0.0894841775F * lab.y - 1.2914855480F * lab.z;
  const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return {4.0767416621F * l3 - 3.3077115913F * m3 + 0.2309699292F * s3,
          -1.2684380046F * l3 + 2.6097574011F * m3 - 0.3413193965F * s3,
          -0.0041960863F * l3 - 0.7034186147F * m3 + 1.7076147010F * s3};
}

/// As colourful as the primaries allow, and as bright.
Rgb withoutNegative(const Rgb& color) {
  const float least = std::min({color.r, color.g, color.b});
  if (least >= 0) return color;
  const float grey = std::max(luminanceOf(color), 0.0F);
  if (grey <= 0) return Rgb(0);
  return glm::max(grey + grey / (grey - least) * (color - grey), Rgb(0));
}

Rgb shifted(const RecolorOperation& operation, const Rgb& light) {
  const Rgb lab = oklabFromLinear(light);
  const float angle = operation.hue * std::numbers::pi_v<float> / 180;
  const float cosine = operation.saturation * std::cos(angle), sine = operation.saturation * std::sin(angle);
  return operation.lightness *
         linearFromOklab({lab.x, cosine * lab.y - sine * lab.z, sine * lab.y + cosine * lab.z});
}

/// The light as a of a colour and s of white, least squares, neither below 0 (Shafer's dichromatic model,
/// 1985). No white beside a colour that is hardly one.
struct Parts {
  float color = 0, white = 0;
};
Parts partsOf(const Rgb& light, const Rgb& color) {
  constexpr float kGrey = 0.02F;  // sine squared of the angle to grey, about 8 degrees
  const float cc = glm::dot(color, color), cw = color.r + color.g + color.b;
  const float cl = glm::dot(color, light), wl = light.r + light.g + light.b;
  const float determinant = 3 * cc - cw * cw;
  if (!(determinant > kGrey * 3 * cc)) return {cl / cc, 0};
  const float own = (3 * cl - cw * wl) / determinant, white = (cc * wl - cw * cl) / determinant;
  if (own < 0) return {0, wl / 3};
  return white < 0 ? Parts{cl / cc, 0} : Parts{own, white};
}

Rgb replaced(const RecolorOperation& operation, const Rgb& light) {
  const Rgb &from = operation.from, &to = operation.to;
  const float ownLuminance = luminanceOf(from);
  if (!(ownLuminance > 0)) return light;
  const Parts parts = partsOf(light, from);
  const Rgb texture = light - parts.color * from - parts.white;
  return parts.color * to + parts.white + luminanceOf(to) / ownLuminance * texture;
}

}  // namespace

std::string RecolorOperation::summary() const {
  if (kind == Kind::Color) return "to a colour";
  return fmt::format("{:+.0f}\u00b0, {:.0f} %, x {:.2f}", hue, 100 * saturation, lightness);
}

Rgb RecolorOperation::recolored(const Rgb& light) const {
  if (kind == Kind::Color) return from == to ? light : withoutNegative(replaced(*this, light));
  if (hue == 0 && saturation == 1) return lightness * light;
  return withoutNegative(shifted(*this, light));
}

}  // namespace swaplight
