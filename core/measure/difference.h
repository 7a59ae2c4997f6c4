#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/measure/delta_e.h"
#include "core/plot/statistics.h"

namespace swaplight {

/// How two pictures differ at a pixel.
enum class Metric {
  DeltaE2000,  ///< CIEDE2000 of the pictures as displayed (scaled, clipped to 0..1)
  AbsDiff,     ///< mean over the channels of |test - reference|
  Rmse,        ///< root of the mean over the channels of (test - reference)^2
  Psnr,        ///< 20 log10(peak / rmse) in dB, at most kLargestPsnr (where the pixels are equal)
};
constexpr double kLargestPsnr = 200;

[[nodiscard]] std::string metricName(Metric metric);   ///< de2000, absdiff, rmse, psnr: as typed
[[nodiscard]] std::string metricLabel(Metric metric);  ///< for people, with its unit
/// From a comma-joined list of names. Throws InputError that lists the known ones.
[[nodiscard]] std::vector<Metric> metricsFromNames(const std::string& names);

/// Two pictures ready to be compared, of one size and with the same channels: R G B, or for all metrics but
/// de2000 any.
struct PicturePair {
  Image test;
  Image reference;
  /// True where both were sRGB-encoded files: absdiff, rmse and psnr are then of code values 0..1, else of
  /// linear light.
  bool encoded = false;
  float scale = 1;  ///< linear light is shown times this: 1/scale is white, and the peak of psnr
};

/// Turns the sRGB code values of all channels into linear light.
void linearize(Image& image);

/// The scale that brings the 99.5th percentile of all finite values of R, G and B to .9. 1 for a black
/// picture.
[[nodiscard]] float displayScale(ImageView reference);

struct DifferenceOptions {
  DeltaEWeights weights;            ///< of de2000
  std::optional<double> threshold;  ///< asks for the share of pixels that differ by more
  bool operator==(const DifferenceOptions&) const = default;
};

struct Difference {
  Metric metric = Metric::DeltaE2000;
  Image map;              ///< one value a pixel; NaN where either picture is not finite
  Statistics statistics;  ///< of the map's finite values
  /// One figure for the pair: the mean of de2000 and absdiff; rmse and psnr over all pixels and channels
  /// (which is not the mean over pixels).
  double value = 0;
  /// Share of the finite values above the threshold, 0..1. Nothing where none was given, and for psnr, of
  /// which more is better.
  std::optional<double> shareAbove = {};
};

/// Throws InputError where no pixel is finite in both pictures.
[[nodiscard]] Difference difference(const PicturePair& pair, Metric metric,
                                    const DifferenceOptions& options = {});

}  // namespace swaplight
