#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace swaplight {

/// A set's contributions at a small size (see UmbraOddsTuning::longest), in the forms that evidence is made
/// from.
struct SmallSet {
  std::vector<cv::Mat> rgb;   ///< R G B float, a light each, in units of white
  std::vector<cv::Mat> grey;  ///< their means over the channels
  cv::Mat totalRgb, total;    ///< sums over the lights
  cv::Mat reflectance;        ///< log of what the lights share (see sharedReflectance), mean 0
  std::array<cv::Mat, 3>
      totalAround;  ///< log of the total's mean around, as far as 12, 35 and 100 units (see referenceUnit)
};

/// `contributions`: as in SetEvidence; `size`: of the small pictures.
[[nodiscard]] SmallSet smallSetOf(const std::vector<cv::Mat>& contributions, cv::Size size);

/// What speaks for and against a pixel lying in one light's umbra: float pictures of the small size, in the
/// order of umbraFeatureNames(). All are logarithms and their differences, so neither the exposure nor the
/// light's strength matters but against the rest of the set:
/// - the light's level over that of its lit parts, plain, over the other lights', and less the reflectance
///   (in full and in half);
/// - how far it lies below the highest and above the lowest level near by: an umbra has light beside it, and
///   a lit pixel does not lie at the floor that bounce leaves;
/// - the same along one surface (a normalised domain transform, guided by the other lights): cast edges
///   divide a surface that the other lights show to be one;
/// - the level over what the light sends into the surroundings, against the same of all lights: bounce comes
///   from there, and is smooth;
/// - its colour: bounce has that of the set;
/// - steps that the other lights do not share.
/// What a whole light is like (its range of levels, its share of all light) and plain levels are none of
/// them: sets fitted to know their own kind by these, and other kinds are then told wrongly.
[[nodiscard]] std::vector<cv::Mat> umbraFeatures(const SmallSet& set, size_t light);

[[nodiscard]] std::span<const std::string_view> umbraFeatureNames();

}  // namespace swaplight
