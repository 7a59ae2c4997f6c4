#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/linear/graph_solver.h"

namespace swaplight {

/// Fills the pixels where `fixed` (8-bit) is 0 with the smoothest continuation of the others: minimises the
/// sum over neighbours of w * difference^2, w = 1 / (1 + (difference of guide / edge)^4), so that what is
/// separated by an edge of the guide is filled separately. The guide has three 32-bit float channels. Where
/// nothing is fixed everything stays.
class SmoothFill {
 public:
  SmoothFill(const cv::Mat& fixed, const cv::Mat& guide, float edge);
  /// One 32-bit float channel, filled.
  [[nodiscard]] cv::Mat of(const cv::Mat& values) const;

 private:
  struct Pull {
    int node;
    cv::Point from;
    float weight;
  };
  cv::Mat m_fixed;
  std::vector<Pull> m_pulls;
  std::optional<GraphSolver> m_solver;  ///< nothing: all is fixed, or nothing
};
[[nodiscard]] cv::Mat fillSmoothly(const cv::Mat& values, const cv::Mat& fixed, const cv::Mat& guide,
                                   float edge);

}  // namespace swaplight
