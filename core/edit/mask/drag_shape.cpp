#include "core/edit/mask/drag_shape.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

/// The end of a drag across a box that is as wide as high.
Point squareEnd(Point from, Point to) {
  const float dx = to[0] - from[0], dy = to[1] - from[1];
  const float side = std::max(std::abs(dx), std::abs(dy));
  return {from[0] + std::copysign(side, dx), from[1] + std::copysign(side, dy)};
}

template <typename T>
concept HasText = requires(T s) {
  s.text;
};
template <typename T>
concept HasFile = requires(T s) {
  s.file;
};
// A selection is softened as a whole, not by the stencil.
template <typename T>
concept HasFeather = !std::is_same_v<T, SelectionShape> && requires(T s) {
  s.feather;
};
template <typename T>
concept DragsDirection = requires {
  T::kDragsDirection;
};

std::vector<StencilKind> listedStencils() {
  std::vector<StencilKind> kinds;
  forEachShape([&]<typename T>(const T&) {
    if constexpr (requires { T::stencil; })
      kinds.push_back(
          {T::info, T::stencil, HasText<T>, HasFile<T>, HasFeather<T>, std::is_same_v<T, PatternShape>});
  });
  return kinds;
}

}  // namespace

const std::vector<StencilKind>& stencilKinds() {
  static const std::vector<StencilKind> kKinds = listedStencils();
  return kKinds;
}

const StencilKind& kindOf(const Stencil& stencil) {
  const auto& kinds = stencilKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const StencilKind& kind) { return kind.info.name == stencil.shape; });
  return found == kinds.end() ? kinds.front() : *found;
}

MaskShape draggedShape(const Stencil& stencil, Point from, Point to, bool even) {
  MaskShape placed;
  forEachShape([&]<typename T>(const T& shape) {
    if constexpr (requires(T s, StencilDrag drag) { s.place(drag); }) {
      if (stencil.shape != T::info.name) return;
      if (even) to = DragsDirection<T> ? evenDirection(from, to) : squareEnd(from, to);
      T next = std::get<T>(withStencil({shape, false}, stencil).shape);
      next.place(StencilDrag(from, to));
      placed = {std::move(next), false};
    }
  });
  return placed;
}

std::optional<ShapeBox> boxOf(const MaskShape& shape) {
  return std::visit(
      [](const auto& s) -> std::optional<ShapeBox> {
        if constexpr (requires { s.box(); }) return s.box();
        return std::nullopt;
      },
      shape.shape);
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

bool isOfKind(const MaskShape& shape, const Stencil& stencil) {
  return std::visit([&](const auto& s) { return stencil.shape == s.info.name; }, shape.shape);
}

MaskShape withStencil(const MaskShape& shape, const Stencil& stencil) {
  MaskShape changed = shape;
  std::visit(
      [&]<typename T>(T& s) {
        if constexpr (HasFeather<T>) s.feather = stencil.feather;
        if constexpr (HasText<T>) s.text = stencil.text;
        if constexpr (HasFile<T>) s.file = stencil.file;
        if constexpr (std::is_same_v<T, PatternShape>) s.kind = stencil.pattern;
      },
      changed.shape);
  return changed;
}

}  // namespace swaplight
