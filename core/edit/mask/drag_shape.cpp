#include "core/edit/mask/drag_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/plot/text_drawing.h"

namespace swaplight {
namespace {

using Kind = ShapeKind::Kind;
using Point = std::array<float, 2>;

constexpr int kMeasuredHeight = 200;  // of a line whose width is measured
constexpr float kLeastSide = 2;
constexpr float kRadialCore = .25F;  // of a radial gradient's radius

/// The end of the drag, made even.
Point evenEnd(Kind kind, Point from, Point to) {
  if (kind == Kind::Linear || kind == Kind::Pattern) return evenDirection(from, to);
  const float dx = to[0] - from[0], dy = to[1] - from[1];
  const float side = std::max(std::abs(dx), std::abs(dy));
  return {from[0] + std::copysign(side, dx), from[1] + std::copysign(side, dy)};
}

TextShape dragText(const ShapeKind& kind, Point from, Point to) {
  TextShape shape;
  shape.text = kind.text;
  shape.x = std::min(from[0], to[0]);
  shape.y = std::max(from[1], to[1]);
  const int measured = std::max(1, textSize(kind.text, kMeasuredHeight).width);
  shape.height = std::max(8.F, std::abs(to[0] - from[0]) * kMeasuredHeight / static_cast<float>(measured));
  shape.feather = kind.feather;
  return shape;
}

}  // namespace

Point evenDirection(Point from, Point to) {
  const float step = std::numbers::pi_v<float> / 4;
  const float dx = to[0] - from[0], dy = to[1] - from[1];
  const float angle = step * std::round(std::atan2(dy, dx) / step);
  const float length = std::hypot(dx, dy);
  return {from[0] + length * std::cos(angle), from[1] + length * std::sin(angle)};
}

MaskShape draggedShape(const ShapeKind& kind, Point from, Point to, bool even) {
  if (even) to = evenEnd(kind.kind, from, to);
  const float x = std::min(from[0], to[0]), y = std::min(from[1], to[1]);
  const float width = std::max(std::abs(to[0] - from[0]), kLeastSide);
  const float height = std::max(std::abs(to[1] - from[1]), kLeastSide);
  const float length = std::hypot(to[0] - from[0], to[1] - from[1]);
  switch (kind.kind) {
    case Kind::Text:
      return {dragText(kind, from, to), false};
    case Kind::Ellipse:
      return {EllipseShape{x + width / 2, y + height / 2, width / 2, height / 2, kind.feather}, false};
    case Kind::Rectangle:
      return {RectangleShape{x, y, width, height, kind.feather}, false};
    case Kind::Pattern: {
      PatternShape pattern;
      pattern.kind = kind.pattern;
      pattern.size = std::max(length, 4.F);
      pattern.angle = -std::atan2(to[1] - from[1], to[0] - from[0]) * 180 / std::numbers::pi_v<float>;
      pattern.feather = kind.feather;
      return {pattern, false};
    }
    case Kind::Picture:
      return {PictureShape{kind.file, x, y, width, height}, false};
    case Kind::Linear:
      return {LinearGradientShape{from[0], from[1], to[0], to[1]}, false};
    case Kind::Radial:
      return {RadialGradientShape{from[0], from[1], kRadialCore * length, std::max(length, kLeastSide)},
              false};
  }
  return {};
}

std::optional<ShapeBox> boxOf(const MaskShape& shape) {
  const auto around = [](float x, float y, float rx, float ry) {
    return ShapeBox{x - rx, y - ry, x + rx, y + ry};
  };
  const auto corner = [](float x, float y, float width, float height) {
    return ShapeBox{x, y, x + width, y + height};
  };
  if (const auto* s = std::get_if<RectangleShape>(&shape.shape))
    return corner(s->x, s->y, s->width, s->height);
  if (const auto* s = std::get_if<EllipseShape>(&shape.shape))
    return around(s->x, s->y, s->radiusX, s->radiusY);
  if (const auto* s = std::get_if<PictureShape>(&shape.shape); s && s->width > 0 && s->height > 0)
    return corner(s->x, s->y, s->width, s->height);
  if (const auto* s = std::get_if<RadialGradientShape>(&shape.shape))
    return around(s->x, s->y, s->outer, s->outer);
  if (const auto* s = std::get_if<TextShape>(&shape.shape)) {
    const cv::Size size = textSize(s->text, std::max(1, static_cast<int>(std::lround(s->height))));
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    return corner(s->x, s->y - height, width, height);
  }
  return std::nullopt;
}

MaskShape movedShape(const MaskShape& shape, float dx, float dy) {
  MaskShape moved = shape;
  std::visit(
      [&](auto& s) {
        if constexpr (requires { s.x0; }) {
          s.x0 += dx, s.x1 += dx, s.y0 += dy, s.y1 += dy;
        } else if constexpr (
            requires { s.x += dx; } && !requires { s.region; }) {
          using Number = decltype(s.x);
          s.x += static_cast<Number>(dx), s.y += static_cast<Number>(dy);
        }
      },
      moved.shape);
  return moved;
}

bool isOfKind(const MaskShape& shape, Kind kind) {
  switch (kind) {
    case Kind::Text:
      return std::holds_alternative<TextShape>(shape.shape);
    case Kind::Ellipse:
      return std::holds_alternative<EllipseShape>(shape.shape);
    case Kind::Rectangle:
      return std::holds_alternative<RectangleShape>(shape.shape);
    case Kind::Pattern:
      return std::holds_alternative<PatternShape>(shape.shape);
    case Kind::Picture:
      return std::holds_alternative<PictureShape>(shape.shape);
    case Kind::Linear:
      return std::holds_alternative<LinearGradientShape>(shape.shape);
    case Kind::Radial:
      return std::holds_alternative<RadialGradientShape>(shape.shape);
  }
  return false;
}

MaskShape withKind(const MaskShape& shape, const ShapeKind& kind) {
  MaskShape changed = shape;
  std::visit(
      [&](auto& s) {
        if constexpr (
            requires { s.feather = kind.feather; } && !requires { s.parts; })
          s.feather = kind.feather;
        if constexpr (requires { s.text = kind.text; }) s.text = kind.text;
        if constexpr (requires { s.file = kind.file; }) s.file = kind.file;
        if constexpr (requires { s.cover; }) s.kind = kind.pattern;
      },
      changed.shape);
  return changed;
}

}  // namespace swaplight
