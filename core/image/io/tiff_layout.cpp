#include "core/image/io/tiff_layout.h"

#include "core/base/error.h"

namespace swaplight {
namespace {

// PhotometricInterpretation (TIFF 6.0, section 8 and 16).
constexpr int kWhiteIsZero = 0;
constexpr int kPalette = 3;

int bitsOf(const OIIO::ImageSpec& spec) {
  // Of a palette "oiio:BitsPerSample" is what a channel of the colours has.
  return spec.get_int_attribute("tiff:BitsPerSample", spec.get_int_attribute("oiio:BitsPerSample", 8));
}

bool isIndex(int bits) {
  return bits == 1 || bits == 2 || bits == 4 || bits == 8 || bits == 16;
}

/// What OpenImageIO misreads in such a picture; empty: nothing that is known.
std::string misread(const OIIO::ImageSpec& spec) {
  const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1);
  const int bits = bitsOf(spec);
  const bool tiled = spec.tile_width > 0;
  const bool interleaved = spec.get_string_attribute("planarconfig") != "separate";
  if (spec.get_string_attribute("tiff:ColorSpace") == "CMYK") {
    if (tiled) return "four inks (CMYK) in tiles";
    const bool whole = bits == 8 || bits == 16;
    if (bits > 16 || (interleaved && !whole)) return fmt::format("four inks (CMYK) of {} bits", bits);
  }
  if (photometric == kPalette && !isIndex(bits)) return fmt::format("a colour table of {} bits", bits);
  if (photometric == kPalette && spec.alpha_channel >= 0) return "a colour table with transparency";
  if (photometric == kWhiteIsZero && spec.nchannels > 1) return "several channels whose white is 0";
  return bits == 24 || bits == 64 ? fmt::format("numbers of {} bits", bits) : std::string();
}

}  // namespace

void checkTiffLayout(const std::string& name, const OIIO::ImageSpec& spec) {
  if (const std::string what = misread(spec); !what.empty())
    throw InputError(
        "{}: is a TIFF of {}, which cannot be read here. Save it as RGB with 8, 16 or 32 bits, without "
        "tiles.",
        name, what);
}

}  // namespace swaplight
