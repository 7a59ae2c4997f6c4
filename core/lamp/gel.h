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
  float miredShift = 0;    ///< Correction: added to 1e6 / Kelvin; negative is bluer
  float green = 0;         ///< Correction: 1 = full plus green
  float transmission = 1;  ///< 0..1
  Rgb filter{1, 1, 1};     ///< Color: transmission of each channel, seen under daylight
  /// How its colour is known.
  enum class Source {
    ByEye,      ///< made for trying out
    Maker,      ///< follows from the maker's shift or density
    Published,  ///< printed in the dissertation that this program follows (Lindsay 2013, 6.4)
    Table,      ///< a person's table, which does not say
    Measured,   ///< a person's table: by a photograph of a chart (swaplight chart)
  };
  Source source = Source::Table;
};

/// For people: "by eye", "maker", "published", "own table", "measured".
[[nodiscard]] const char* sourceName(Gel::Source source);

/// The built-in table: correction gels by their mired shift, neutral densities, the four gels of Lindsay
/// (2013, 6.4), and a few colours of our own making, for trying out; no maker's table.
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
/// any order, and one more, source, where "measured" is a gel that was; lines that begin with # are skipped.
/// Throws InputError with the line.
[[nodiscard]] std::vector<Gel> gelsFromCsv(const std::string& text, const std::string& fileName);

/// A table's text. Throws InputError that names the file: missing, unreadable, larger than any table is.
[[nodiscard]] std::string readGelTable(const std::filesystem::path& csv);

/// What a gel is called in a table.
struct GelLabel {
  std::string brand, number, name;

  /// "Rosco,4660,60 Red"; the name may be left out. Throws InputError that quotes the text.
  [[nodiscard]] static GelLabel fromText(const std::string& text);
};

/// A table (see gelsFromCsv; "" is none yet) with one gel more, a measured one: `filter` is what it lets
/// through of each linear Rec.709 channel of white. The table keeps its columns and their order. Throws
/// InputError as gelsFromCsv does, where the table has the gel already, where nothing passes the filter,
/// or more than all.
[[nodiscard]] std::string withMeasuredGel(const std::string& table, const std::string& fileName,
                                          const GelLabel& label, const Rgb& filter);

/// The same in measured.csv among the person's tables in the data folder, from where it is among the gels at
/// once. Returns the gel. Throws InputError as above, and where the folder cannot be written.
const Gel& addMeasuredGel(const GelLabel& label, const Rgb& filter);

}  // namespace swaplight
