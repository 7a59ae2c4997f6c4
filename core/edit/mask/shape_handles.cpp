#include "core/edit/mask/shape_handles.h"

#include <algorithm>
#include <cmath>

#include "core/edit/mask/drag_shape.h"

namespace swaplight {
namespace {

using What = ShapeHandle::What;
using Point = std::array<float, 2>;

constexpr float kLeastSide = 2, kLeastText = 8;  // pixels

Point middleOf(const ShapeBox& box) {
  return {(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
}

bool isLeft(What corner) {
  return corner == What::TopLeft || corner == What::BottomLeft;
}
bool isTop(What corner) {
  return corner == What::TopLeft || corner == What::TopRight;
}

Point cornerOf(const ShapeBox& box, What corner) {
  return {isLeft(corner) ? box.x0 : box.x1, isTop(corner) ? box.y0 : box.y1};
}

Point oppositeOf(const ShapeBox& box, What corner) {
  return {isLeft(corner) ? box.x1 : box.x0, isTop(corner) ? box.y1 : box.y0};
}

/// How much larger the box becomes for its corner to lie next to the point on its diagonal.
float scaleTo(const ShapeBox& box, What corner, Point to) {
  const Point fixed = oppositeOf(box, corner), from = cornerOf(box, corner);
  const float dx = from[0] - fixed[0], dy = from[1] - fixed[1];
  const float length2 = dx * dx + dy * dy;
  const float along = ((to[0] - fixed[0]) * dx + (to[1] - fixed[1]) * dy) / std::max(length2, 1.F);
  return std::max(along, 0.F);
}

/// The box with a corner elsewhere; it does not turn over.
ShapeBox withCorner(const ShapeBox& box, What corner, Point to, bool even) {
  const Point fixed = oppositeOf(box, corner);
  if (even) {
    const Point from = cornerOf(box, corner);
    const float scale = scaleTo(box, corner, to);
    to = {fixed[0] + scale * (from[0] - fixed[0]), fixed[1] + scale * (from[1] - fixed[1])};
  }
  const float width = std::max(isLeft(corner) ? fixed[0] - to[0] : to[0] - fixed[0], kLeastSide);
  const float height = std::max(isTop(corner) ? fixed[1] - to[1] : to[1] - fixed[1], kLeastSide);
  const float x = isLeft(corner) ? fixed[0] - width : fixed[0];
  const float y = isTop(corner) ? fixed[1] - height : fixed[1];
  return {x, y, x + width, y + height};
}

void setEnd(LinearGradientShape& line, What end, Point to, bool even) {
  if (end == What::From) {
    if (even) to = evenDirection({line.x1, line.y1}, to);
    line.x0 = to[0], line.y0 = to[1];
  } else if (end == What::To) {
    if (even) to = evenDirection({line.x0, line.y0}, to);
    line.x1 = to[0], line.y1 = to[1];
  }
}

void setRadius(RadialGradientShape& ring, What which, Point to) {
  const float radius = std::hypot(to[0] - ring.x, to[1] - ring.y);
  if (which == What::Inner) ring.inner = std::min(radius, ring.outer);
  if (which != What::Outer) return;
  ring.outer = std::max(radius, kLeastSide);
  ring.inner = std::min(ring.inner, ring.outer);
}

void setBox(RectangleShape& s, const ShapeBox& box) {
  s.x = box.x0, s.y = box.y0, s.width = box.x1 - box.x0, s.height = box.y1 - box.y0;
}
void setBox(PictureShape& s, const ShapeBox& box) {
  s.x = box.x0, s.y = box.y0, s.width = box.x1 - box.x0, s.height = box.y1 - box.y0;
}
void setBox(EllipseShape& s, const ShapeBox& box) {
  const Point middle = middleOf(box);
  s.x = middle[0], s.y = middle[1], s.radiusX = (box.x1 - box.x0) / 2, s.radiusY = (box.y1 - box.y0) / 2;
}

/// The words at another size. Their drawn width is in whole pixels: the corner that stays is kept in place.
MaskShape withTextCorner(const MaskShape& shape, const ShapeBox& box, What corner, Point to) {
  MaskShape next = shape;
  auto& text = std::get<TextShape>(next.shape);
  text.height = std::max(text.height * scaleTo(box, corner, to), kLeastText);
  const Point fixed = oppositeOf(box, corner);
  const Point now = oppositeOf(boxOf(next).value(), corner);
  text.x += fixed[0] - now[0], text.y += fixed[1] - now[1];
  return next;
}

bool isCorner(What what) {
  return what == What::TopLeft || what == What::TopRight || what == What::BottomLeft ||
         what == What::BottomRight;
}

}  // namespace

const char* handleName(What what) {
  constexpr std::array<const char*, 9> kNames{"middle",   "from",      "to",          "inner",       "outer",
                                              "top_left", "top_right", "bottom_left", "bottom_right"};
  return kNames.at(static_cast<size_t>(what));
}

std::vector<ShapeHandle> handlesOf(const MaskShape& shape) {
  if (const auto* line = std::get_if<LinearGradientShape>(&shape.shape))
    return {{What::To, {line->x1, line->y1}},
            {What::From, {line->x0, line->y0}},
            {What::Middle, {(line->x0 + line->x1) / 2, (line->y0 + line->y1) / 2}}};
  if (const auto* ring = std::get_if<RadialGradientShape>(&shape.shape))
    return {{What::Outer, {ring->x + ring->outer, ring->y}},
            {What::Inner, {ring->x - ring->inner, ring->y}},
            {What::Middle, {ring->x, ring->y}}};
  const auto box = boxOf(shape);
  if (!box) return {};
  std::vector<ShapeHandle> handles;
  for (const What corner : {What::BottomRight, What::TopLeft, What::TopRight, What::BottomLeft})
    handles.push_back({corner, cornerOf(*box, corner)});
  handles.push_back({What::Middle, middleOf(*box)});
  return handles;
}

MaskShape withHandleAt(const MaskShape& shape, What handle, Point to, bool even) {
  if (handle == What::Middle) {
    for (const ShapeHandle& one : handlesOf(shape))
      if (one.what == handle) return movedShape(shape, to[0] - one.at[0], to[1] - one.at[1]);
    return shape;
  }
  MaskShape next = shape;
  if (auto* line = std::get_if<LinearGradientShape>(&next.shape)) {
    setEnd(*line, handle, to, even);
  } else if (auto* ring = std::get_if<RadialGradientShape>(&next.shape)) {
    setRadius(*ring, handle, to);
  } else if (const auto box = boxOf(shape); box && isCorner(handle)) {
    if (std::holds_alternative<TextShape>(shape.shape)) return withTextCorner(shape, *box, handle, to);
    std::visit(
        [&](auto& s) {
          if constexpr (requires { setBox(s, *box); }) setBox(s, withCorner(*box, handle, to, even));
        },
        next.shape);
  }
  return next;
}

}  // namespace swaplight
