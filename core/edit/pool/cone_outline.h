#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace swaplight {

/// The border of what a spot lights, as it is seen: where a cone falls on a wall and on the floor before it,
/// it is no ellipse. Shadows and things in front that bite into it are filled; where it meets the picture's
/// border it goes on straight. Lengths are widths of the picture, x to the right and y up from its middle.
class ConeOutline {
 public:
  /// Of the largest lit part of a picture (32-bit float, 0 no light .. 1 as everywhere where it shines).
  /// Nothing where there is none, or no end of it.
  static std::optional<ConeOutline> in(const cv::Mat& seen);

  [[nodiscard]] cv::Point2d middle() const { return m_middle; }
  /// Does it go on beyond the picture?
  [[nodiscard]] bool isCut() const { return m_cut; }
  /// Of a disk of the same area.
  [[nodiscard]] double spread() const { return m_spread; }
  /// 0 in its middle, 1 at its edge; the same distance from the edge is the same radius everywhere.
  [[nodiscard]] double radius(double px, double py) const;
  /// The edge brought to a radius.
  void setEdge(double radius);

 private:
  cv::Mat m_inside;  // how far inside a pixel lies, widths: the picture with a margin around it
  int m_columns = 0, m_rows = 0, m_margin = 0;  // of the picture
  cv::Point2d m_middle;
  double m_spread = 1;
  bool m_cut = false;
  double m_deepest = 1;  // a radius
  double m_shift = 0;    // of the edge, inwards
};

}  // namespace swaplight
