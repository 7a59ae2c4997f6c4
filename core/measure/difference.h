#pragma once

#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/plot/statistics.h"

namespace swaplight {

/// How two pictures differ at a pixel.
enum class Metric {
  DeltaE2000,  ///< CIEDE2000 of the pictures as displayed (scaled, clipped to 0..1)
  AbsDiff,     ///< mean over R G B of |test - reference|
  Rmse,        ///< root of the mean over R G B of (test - reference)^2
  Psnr,        ///< 20 log10(peak / rmse) in dB, at most kLargestPsnr (where the pixels are equal)
};
constexpr double kLargestPsnr = 200;

[[nodiscard]] std::string metricName(Metric metric);   ///< de2000, absdiff, rmse, psnr: as typed
[[nodiscard]] std::string metricLabel(Metric metric);  ///< for people, with its unit
/// From a comma-joined list of names. Throws InputError that lists the known ones.
[[nodiscard]] std::vector<Metric> metricsFromNames(const std::string& names);

/// Two pictures ready to be compared: R G B, one size.
struct PicturePair {
  Image test;
  Image reference;
  /// True where both were sRGB-encoded files: absdiff, rmse and psnr are then of code values 0..1, else of
  /// linear light.
  bool encoded = false;
  float scale = 1;  ///< linear light is shown times this: 1/scale is white, and the peak of psnr
};

/// The scale that brings the 99.5th percentile of all finite values of R, G and B to .9. 1 for a black
/// picture.
[[nodiscard]] float displayScale(ImageView reference);

struct Difference {
  Metric metric = Metric::DeltaE2000;
  Image map;              ///< one value a pixel; NaN where either picture is not finite
  Statistics statistics;  ///< of the map's finite values
  /// One figure for the pair: the mean of de2000 and absdiff; rmse and psnr over all pixels and channels
  /// (which is not the mean over pixels).
  double value = 0;
};

/// Throws InputError where no pixel is finite in both pictures.
[[nodiscard]] Difference difference(const PicturePair& pair, Metric metric);

}  // namespace swaplight
