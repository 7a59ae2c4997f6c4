#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/capture/capture.h"
#include "core/color/rgb.h"
#include "core/image/image.h"

namespace swaplight {

/// The colour that a light had in a shot, as a person says it.
struct ShotColor {
  std::string text;          ///< as written: "L106", "0.9/0.2/0.1", "unknown", "?a"
  std::optional<Rgb> color;  ///< linear; nothing: unknown

  /// "?a" where that is what it is called: the same unknown wherever it stands. "" otherwise.
  [[nodiscard]] std::string name() const { return !color && isColorName(text) ? text : ""; }
  bool operator==(const ShotColor&) const = default;
};

/// A gel by its number (white through it), linear r/g/b, #rrggbb, 3200K, any other colour SETTING, off, or
/// unknown, or the name of an unknown colour, ?a. Throws InputError that quotes the text.
[[nodiscard]] ShotColor shotColorFromText(const std::string& text);
/// Several, apart by commas.
[[nodiscard]] std::vector<ShotColor> shotColorsFromText(const std::string& text);

/// Gels that travel from light to light: each that is unknown and has no name is given one, ?a, ?b ...
[[nodiscard]] std::vector<ShotColor> namedUnknowns(std::vector<ShotColor> ring);

/// A colour as linear r/g/b.
[[nodiscard]] ShotColor shotColorFromRgb(const Rgb& color);

/// The mean of a square of a shot, as of a white card that one light shines on: its light in linear R G B.
/// The square lies around a pixel and inside of the picture. Throws InputError where the pixel is outside,
/// where nothing is finite, and for black.
[[nodiscard]] ShotColor colorOfCard(const Image& shot, int x, int y, int side = 9);

}  // namespace swaplight
