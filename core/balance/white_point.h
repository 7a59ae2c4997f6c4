#pragma once

#include <span>
#include <string>

#include "core/color/rgb.h"
#include "core/relight/rig.h"

namespace swaplight {

/// The white that lamps or a picture are balanced to: on the locus of core/lamp/kelvin.h, or beside it.
struct WhitePoint {
  double kelvin = 6504;  ///< 1000..25000
  double duv = 0;        ///< CIE 1960, positive: green; -.05..+.05
  bool operator==(const WhitePoint&) const = default;
};

/// Those with names, warm to cool: A (CIE illuminant A, 2856 K), D50, D55, D60, D65. E is no light that
/// exists and is not offered.
struct NamedWhite {
  const char* name;
  const char* description;  ///< for people
  WhitePoint white;
};
[[nodiscard]] std::span<const NamedWhite> namedWhites();

/// "D65", "4300K", or either with a Duv: "4300K,duv:+0.003". Throws InputError that quotes the text and lists
/// what would be right.
[[nodiscard]] WhitePoint whitePointFromText(const std::string& text);
/// The shortest text that whitePointFromText reads back.
[[nodiscard]] std::string textFromWhitePoint(const WhitePoint& white);

/// Linear Rec.709 of luminance 1. D65 is exactly {1, 1, 1}.
[[nodiscard]] Rgb colorOfWhite(const WhitePoint& white);
/// The same as a lamp's colour: white at D65, else Kelvin, with plus or minus green for the Duv.
[[nodiscard]] LightColor lightColorOfWhite(const WhitePoint& white);

}  // namespace swaplight
