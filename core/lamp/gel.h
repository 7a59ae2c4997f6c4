#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/color/rgb.h"

namespace swaplight {

/// A colour filter in front of a lamp. Like the real one it takes light away: `transmission` is the luminance
/// that passes of the white it is made for.
struct Gel {
  enum class Kind {
    Correction,  ///< shifts white along its locus (miredShift) and across (green)
    Neutral,     ///< takes light only
    Color,       ///< multiplies each linear Rec.709 channel (filter)
  };
  std::string id;  ///< the maker's letter and the number: L201
  std::string name;
  Kind kind = Kind::Color;
  float miredShift = 0;     ///< Correction: added to 1e6 / Kelvin; negative is bluer
  float green = 0;          ///< Correction: 1 = full plus green
  float transmission = 1;   ///< 0..1
  Rgb filter{1, 1, 1};      ///< Color: transmission of each channel, seen under daylight
  bool approximate = true;  ///< made by eye; false where it follows from the maker's shift or density
};

/// The built-in table: correction gels by their mired shift, neutral densities, and a few colours of our own
/// making, for trying out; no maker's table.
[[nodiscard]] const std::vector<Gel>& builtInGels();

/// The person's own gels and then the built-in ones. The former are read when this is first called, from
/// gels.csv and from every table in the folder gels/ of the data folder; throws InputError where one has
/// mistakes. The list stays valid for good, also when more are imported.
[[nodiscard]] const std::vector<Gel>& allGels();

/// Takes a table (see gelsFromCsv) into the data folder, from where it is read from now on. Returns how many
/// gels it holds. Throws InputError where it has mistakes or the folder cannot be written.
size_t importGels(const std::filesystem::path& csv);

/// By its id, upper or lower case. Throws InputError that lists the known ones.
[[nodiscard]] const Gel& findGel(const std::string& id);

/// Gels from a table with the columns brand, number, name, x, y, T: the chromaticity of daylight through the
/// gel and its transmission, 0..1 or in percent ("34%" or above 1). The first line may name the columns, in
/// any order; lines that begin with # are skipped. Throws InputError with the line.
[[nodiscard]] std::vector<Gel> gelsFromCsv(const std::string& text, const std::string& fileName);

}  // namespace swaplight
