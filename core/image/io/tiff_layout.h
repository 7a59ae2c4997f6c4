#pragma once

#include <OpenImageIO/imageio.h>

#include <string>

namespace swaplight {

/// Throws InputError for a TIFF that OpenImageIO opens and then reads beyond its memory, or into wrong pixels
/// without a word (2.4.7, Debian 12's; read in its tiffinput.cpp). `spec` is the header as it gives it:
///
/// - Four inks (CMYK), which it turns into three channels, in tiles, or interleaved with other than 8 or 16
///   bits: it unpacks four values a pixel where there is room for three (its issues 5315 and 5296). More than
///   16 bits it refuses itself.
/// - Numbers of 24 bits: it takes their bytes in the wrong order, floats for whole numbers, and leaves those
///   of tiles where they are. Numbers of 64 bits: it leaves those of tiles, and of single rows, too.
/// - A colour table (palette) with an alpha channel, or with indices of 6, 10, 12, 14 or more than 16 bits:
///   it takes other bits for indices, or none.
/// - Several channels whose white is 0: it inverts as many values as the square of their count (its 5083).
void checkTiffLayout(const std::string& name, const OIIO::ImageSpec& spec);

}  // namespace swaplight
