#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/edit/pool/light_cone.h"
#include "core/image/image.h"

namespace swaplight {

/// How much of a light each pixel sees (0..1) when its lamp gets another size.
///
/// A shadow's edge is as wide as the lamp looks big from there, so that it goes with the lamp's diameter. How
/// wide it is now is measured around each pixel, since it grows with the distance to what casts the shadow: a
/// linear ramp of width w has slopes of 1 / w, whose mean, weighted by themselves, is that. From w to q w is
/// a blur of .29 w sqrt(q^2 - 1) (the standard deviation of a ramp is w / sqrt(12)), or a steeper ramp. Edges
/// narrower than two pixels cannot be measured, and stay; so does the edge of a cone, which is no shadow.
///
/// Blurs are kept at powers of two, so that a slider only mixes them.
class PenumbraScales {
 public:
  /// `visibility`: one channel, 0..1; kept, it has to outlive this.
  PenumbraScales(const Image& visibility, const std::optional<LightCone>& cone);

  /// The visibility in a row of pixels with a lamp `times` as wide as it was. Its `diameter` was that, widths
  /// of the picture: no shadow has wider edges than a quarter of it.
  void row(float times, float diameter, int x, int y, int count, float* visibility) const;

 private:
  /// Of the blur that makes edges as wide as they get, or that they lose: standard deviations, pixels.
  void sigmaRow(float times, float diameter, const float* width, const float* cone, int count,
                float* sigma) const;
  /// A few pixels that lie together.
  void blurRow(int x, int y, int count, const float* sigma, float* visibility) const;

  const Image& m_visibility;
  cv::Mat m_cone;                 // 0..1: at the edge of the cone; small
  cv::Mat m_width;                // of the shadow's edge around a pixel, pixels of the picture; small
  std::vector<cv::Mat> m_levels;  // blurred by 1, 2, 4, ... pixels, as small as that allows
};

}  // namespace swaplight
