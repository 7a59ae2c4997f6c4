#include "core/edit/shapes/polygon_shape.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/edit/raster/shape_drawing.h"

namespace swaplight {

MaskRaster PolygonShape::draw(int width, int height) const {
  if (points.size() < 3) return {width, height};
  PixelRect box;
  for (const auto& p : points)
    box = enclosing(box,
                    {cvFloor(std::clamp(p[0], -1e5f, 1e5f)), cvFloor(std::clamp(p[1], -1e5f, 1e5f)), 1, 1});
  const Canvas canvas(feather, box, width, height);
  if (canvas.size.empty()) return {width, height};
  cv::Mat drawn(canvas.size, CV_8U, cv::Scalar(0));
  std::vector<std::vector<cv::Point>> line(1);
  for (const auto& p : points) line[0].push_back(canvas.place(p[0], p[1]));
  cv::fillPoly(drawn, line, cv::Scalar(255), cv::LINE_AA, Canvas::kShift);
  return canvas.soften(drawn, width, height);
}

float PolygonShape::breadth() const {
  if (points.empty()) return 0;
  const auto& first = points.front();
  const auto distance = [&](const auto& p) { return std::hypot(p[0] - first[0], p[1] - first[1]); };
  const auto& far = *std::ranges::max_element(points, {}, distance);
  if (!(distance(far) > 0)) return 0;
  float left = 0, right = 0;
  for (const auto& p : points) {
    const float off =
        ((far[0] - first[0]) * (p[1] - first[1]) - (far[1] - first[1]) * (p[0] - first[0])) / distance(far);
    left = std::max(left, off);
    right = std::max(right, -off);
  }
  return left + right;
}

}  // namespace swaplight
