#include "core/edit/shapes/polygon_shape.h"

#include <algorithm>
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

}  // namespace swaplight
