#pragma once

#include <vector>

#include "core/capture/jpeg/jpeg_coding.h"
#include "core/image/image.h"

namespace swaplight {

/// The variance of an error where a picture has a value.
struct ValueVariance {
  float value = 0, variance = 0;
};

/// The error that a JPEG file's coding has left in its picture: that of the typical block (median) in
/// steps of brightness (a point each; none where there are too few), R, G and B together; `codes` (R G B,
/// 0..1) is the whole picture as decoded, and so are the units.
///
/// A coefficient that is not 0 is wrong by up to half its step q: q^2 / 12. One that was rounded to 0 was
/// smaller than that by as much as the block is smooth: coefficients of a block have the Laplace distribution
/// of the scale a / f^n (f: frequency; Field 1987: n is about 1 for natural pictures). a of a block and n of
/// the picture are the likeliest for what was rounded (expectation-maximisation; Robertson and Stevenson 2005
/// have the same posterior with a scale a coefficient). Colour that is stored
/// once for several pixels has lost one octave more: what varies among as many of the stored values is taken
/// for what varied among the pixels.
[[nodiscard]] std::vector<ValueVariance> jpegError(ImageView codes, const JpegCoding& coding);

}  // namespace swaplight
