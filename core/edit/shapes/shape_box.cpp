#include "core/edit/shapes/shape_box.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swaplight {
namespace {

using What = ShapeHandle::What;

bool isLeft(What corner) {
  return corner == What::TopLeft || corner == What::BottomLeft;
}
bool isTop(What corner) {
  return corner == What::TopLeft || corner == What::TopRight;
}

}  // namespace

bool isCorner(What what) {
  return what == What::TopLeft || what == What::TopRight || what == What::BottomLeft ||
         what == What::BottomRight;
}

Point ShapeBox::corner(What corner) const {
  return {isLeft(corner) ? x0 : x1, isTop(corner) ? y0 : y1};
}

Point ShapeBox::opposite(What corner) const {
  return {isLeft(corner) ? x1 : x0, isTop(corner) ? y1 : y0};
}

float ShapeBox::scaleTo(What what, Point to) const {
  const Point fixed = opposite(what), from = corner(what);
  const float dx = from[0] - fixed[0], dy = from[1] - fixed[1];
  const float length2 = dx * dx + dy * dy;
  const float along = ((to[0] - fixed[0]) * dx + (to[1] - fixed[1]) * dy) / std::max(length2, 1.F);
  return std::max(along, 0.F);
}

ShapeBox ShapeBox::withCorner(What what, Point to, bool even) const {
  const Point fixed = opposite(what);
  if (even) {
    const Point from = corner(what);
    const float scale = scaleTo(what, to);
    to = {fixed[0] + scale * (from[0] - fixed[0]), fixed[1] + scale * (from[1] - fixed[1])};
  }
  const float width = std::max(isLeft(what) ? fixed[0] - to[0] : to[0] - fixed[0], kLeastSide);
  const float height = std::max(isTop(what) ? fixed[1] - to[1] : to[1] - fixed[1], kLeastSide);
  const float x = isLeft(what) ? fixed[0] - width : fixed[0];
  const float y = isTop(what) ? fixed[1] - height : fixed[1];
  return {x, y, x + width, y + height};
}

Point evenDirection(Point from, Point to) {
  const float step = std::numbers::pi_v<float> / 4;
  const float dx = to[0] - from[0], dy = to[1] - from[1];
  const float angle = step * std::round(std::atan2(dy, dx) / step);
  const float length = std::hypot(dx, dy);
  return {from[0] + length * std::cos(angle), from[1] + length * std::sin(angle)};
}

StencilDrag::StencilDrag(Point begin, Point end)
    : from(begin),
      to(end),
      x(std::min(begin[0], end[0])),
      y(std::min(begin[1], end[1])),
      width(std::max(std::abs(end[0] - begin[0]), kLeastSide)),
      height(std::max(std::abs(end[1] - begin[1]), kLeastSide)),
      length(std::hypot(end[0] - begin[0], end[1] - begin[1])) {}

}  // namespace swaplight
