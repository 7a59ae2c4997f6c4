#include "core/edit/shapes/text_shape.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/edit/raster/shape_drawing.h"
#include "core/plot/text_drawing.h"

namespace swaplight {
namespace {

constexpr int kMeasuredHeight = 200;  // of a line whose width is measured
constexpr float kLeastHeight = 8;     // pixels

}  // namespace

MaskRaster TextShape::draw(int pictureWidth, int pictureHeight) const {
  const float most = diagonal(pictureWidth, pictureHeight);
  if (height > most)
    throw InputError("\"text\": its height is {} pixels, in a picture of {} x {}; expected at most {:.0f}.",
                     height, pictureWidth, pictureHeight, most);
  // Only as much as the text may cover, with what hangs below the line.
  const int line = std::max(1, cvRound(height));
  const cv::Point baseline(cvRound(x), cvRound(y));
  const PixelRect around{baseline.x - line, baseline.y - 2 * line, textSize(text, line).width + 2 * line,
                         4 * line};
  const Canvas canvas(feather, around, pictureWidth, pictureHeight);
  if (canvas.size.empty()) return {pictureWidth, pictureHeight};
  cv::Mat drawn(canvas.size, CV_8UC3, cv::Scalar::all(0));
  const cv::Point place((baseline.x - canvas.area.x) / canvas.shrink,
                        (baseline.y - canvas.area.y) / canvas.shrink);
  drawText(drawn, text, place, std::max(1, line / canvas.shrink), cv::Scalar::all(255));
  cv::Mat grey;
  cv::extractChannel(drawn, grey, 0);
  return canvas.soften(grey, pictureWidth, pictureHeight);
}

std::optional<ShapeBox> TextShape::box() const {
  const cv::Size size = textSize(text, std::max(1, static_cast<int>(std::lround(height))));
  const float top = y - static_cast<float>(size.height);
  return ShapeBox{x, top, x + static_cast<float>(size.width), top + static_cast<float>(size.height)};
}

void TextShape::setCorner(ShapeHandle::What corner, Point to) {
  const ShapeBox before = box().value();
  height = std::max(height * before.scaleTo(corner, to), kLeastHeight);
  const Point fixed = before.opposite(corner);
  const Point now = box().value().opposite(corner);
  x += fixed[0] - now[0], y += fixed[1] - now[1];
}

void TextShape::place(const StencilDrag& drag) {
  x = drag.x;
  y = std::max(drag.from[1], drag.to[1]);
  const int measured = std::max(1, textSize(text, kMeasuredHeight).width);
  height = std::max(kLeastHeight,
                    std::abs(drag.to[0] - drag.from[0]) * kMeasuredHeight / static_cast<float>(measured));
}

}  // namespace swaplight
