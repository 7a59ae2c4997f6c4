#include "core/shadow/numeric/smooth_fill.h"

#include <utility>
#include <vector>

namespace swaplight {
namespace {

constexpr float kLeastWeight = 1e-3f;  // keeps every pixel connected
constexpr double kTolerance = 1e-3;    // residual, of the pull of what differs from the mean
constexpr std::pair<int, int> kNeighbours[] = {{0, -1}, {-1, 0}, {1, 0}, {0, 1}};

}  // namespace

SmoothFill::SmoothFill(const cv::Mat& fixed, const cv::Mat& guide, float edge) : m_fixed(fixed.clone()) {
  cv::Mat index(fixed.size(), CV_32S, cv::Scalar(-1));
  int count = 0;
  for (int y = 0; y < fixed.rows; ++y)
    for (int x = 0; x < fixed.cols; ++x)
      if (!fixed.at<uchar>(y, x)) index.at<int>(y, x) = count++;
  if (count == 0 || static_cast<size_t>(count) == fixed.total()) return;

  // Links of the free pixels among each other, and how strongly fixed neighbours pull.
  LinkedNodes nodes;
  for (int y = 0; y < fixed.rows; ++y)
    for (int x = 0; x < fixed.cols; ++x) {
      if (index.at<int>(y, x) < 0) continue;
      float anchor = 0;
      for (const auto& [dx, dy] : kNeighbours) {
        const int x2 = x + dx, y2 = y + dy;
        if (x2 < 0 || y2 < 0 || x2 >= fixed.cols || y2 >= fixed.rows) continue;
        const cv::Vec3f apart = guide.at<cv::Vec3f>(y, x) - guide.at<cv::Vec3f>(y2, x2);
        const float step2 = apart.dot(apart) / (3 * edge * edge);
        const float weight = 1 / (1 + step2 * step2) + kLeastWeight;
        if (const int other = index.at<int>(y2, x2); other >= 0) {
          nodes.neighbour.push_back(other);
          nodes.weight.push_back(weight);
        } else {
          anchor += weight;
          m_pulls.push_back({index.at<int>(y, x), {x2, y2}, weight});
        }
      }
      nodes.anchor.push_back(anchor);
      nodes.first.push_back(static_cast<int>(nodes.neighbour.size()));
    }
  m_solver.emplace(std::move(nodes));
}

cv::Mat SmoothFill::of(const cv::Mat& values) const {
  cv::Mat filled = values.clone();
  if (!m_solver) return filled;
  const size_t count = m_fixed.total() - static_cast<size_t>(cv::countNonZero(m_fixed));
  const auto mean = static_cast<float>(cv::mean(values, m_fixed)[0]);
  std::vector<float> pull(count, 0), solution(count, 0);  // less the mean: no offset makes a residual small
  for (const Pull& each : m_pulls)
    pull[static_cast<size_t>(each.node)] += each.weight * (values.at<float>(each.from) - mean);
  m_solver->solve(pull, solution, kTolerance);
  size_t next = 0;
  for (int y = 0; y < values.rows; ++y)
    for (int x = 0; x < values.cols; ++x)
      if (!m_fixed.at<uchar>(y, x)) filled.at<float>(y, x) = mean + solution[next++];
  return filled;
}

cv::Mat fillSmoothly(const cv::Mat& values, const cv::Mat& fixed, const cv::Mat& guide, float edge) {
  return SmoothFill(fixed, guide, edge).of(values);
}

}  // namespace swaplight
