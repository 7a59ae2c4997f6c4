#include "core/edit/mask/mask_outline.h"

#include <algorithm>

#include "core/shadow/result/label_mask.h"

namespace swaplight {
namespace {

constexpr size_t kFewestPoints = 3;

}  // namespace

std::vector<Outline> maskOutline(const MaskRaster& mask) {
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
  std::vector<Outline> outline = outlinesOfMask(inside, 1, .5F);
  std::erase_if(outline, [](const Outline& line) { return line.size() < kFewestPoints; });
  for (Outline& line : outline)
    for (auto& [x, y] : line) x += static_cast<float>(area.x), y += static_cast<float>(area.y);
  std::sort(outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return outline;
}

}  // namespace swaplight
