#pragma once

#include "core/shadow/odds/umbra_evidence.h"
#include "core/shadow/odds/umbra_network.h"

namespace swaplight {

/// The odds of each light's umbra at the size of a set's pictures, as the network sees them (larger ones at
/// the size that it was taught on) and half as large: there noise is half as strong and a dark wall one
/// surface (what stays of noise in a solved set is blotches, which the network takes for shapes).
class UmbraOdds {
 public:
  explicit UmbraOdds(const SmallSet& set);

  /// Empty pictures where there is nothing to weigh: a light that is the same everywhere, pictures of
  /// less than eight pixels in width or height. May be called from several threads at a time.
  [[nodiscard]] LightOdds of(size_t light) const;

 private:
  cv::Size m_full;
  SmallSet m_fine, m_coarse;
};

}  // namespace swaplight
