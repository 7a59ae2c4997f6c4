#include "core/edit/mask_outline.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace swaplight {
namespace {

constexpr size_t kFewestPoints = 4;

}  // namespace

std::vector<std::vector<std::array<float, 2>>> maskOutline(const MaskRaster& mask) {
  const PixelRect area = mask.bounds();
  if (area.empty()) return {};
  cv::Mat inside(area.height, area.width, CV_8U);
  std::vector<float> row(static_cast<size_t>(area.width));
  for (int y = 0; y < area.height; ++y) {
    std::fill(row.begin(), row.end(), 1.F);
    mask.multiplyRow(area.x, area.y + y, area.width, row.data());
    std::transform(row.begin(), row.end(), inside.ptr<uchar>(y),
                   [](float m) { return static_cast<uchar>(m > .5F ? 255 : 0); });
  }
  std::vector<std::vector<cv::Point>> lines;
  cv::findContours(inside, lines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE, {area.x, area.y});
  std::vector<std::vector<std::array<float, 2>>> outline;
  for (const auto& line : lines) {
    if (line.size() < kFewestPoints) continue;
    std::vector<cv::Point> simple;
    cv::approxPolyDP(line, simple, .5, true);
    auto& points = outline.emplace_back();
    for (const cv::Point& p : simple)
      points.push_back({static_cast<float>(p.x) + .5F, static_cast<float>(p.y) + .5F});
  }
  std::sort(outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return outline;
}

}  // namespace swaplight
