#pragma once

#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// How far a light can be raised or lowered before noise or clipping shows.
struct LightRange {
  std::string light;
  double peak = 0;  ///< luminance under unit white, 99.9th percentile
  double floor =
      0;  ///< its standard error where the picture is dark: the tenth percentile of sigma times the sum
  double stops = 0;  ///< log2(peak / floor); 0 where the light gives nothing
};

/// For each light of a solved set, by at most 2^18 of its pixels, evenly over the picture; empty where the
/// set has no quality. Throws InputError on an unknown colour space.
[[nodiscard]] std::vector<LightRange> dynamicRange(const SolvedSet& set);

[[nodiscard]] Json jsonFromRanges(const std::vector<LightRange>& ranges);
/// Throws InputError that begins with `where`.
[[nodiscard]] std::vector<LightRange> rangesFromJson(const Json& json, const std::string& where);
/// For people: "8.2 stops between the noise and its brightest parts".
[[nodiscard]] std::string rangeWords(const LightRange& range);

}  // namespace swaplight
