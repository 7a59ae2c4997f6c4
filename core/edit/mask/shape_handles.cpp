#include "core/edit/mask/shape_handles.h"

#include "core/edit/mask/drag_shape.h"

namespace swaplight {
namespace {

using What = ShapeHandle::What;

template <typename Shape>
void moveHandle(Shape& shape, What handle, Point to, bool even) {
  if constexpr (requires { shape.setHandle(handle, to, even); }) {
    shape.setHandle(handle, to, even);
  } else if constexpr (requires { shape.setCorner(handle, to); }) {
    if (isCorner(handle)) shape.setCorner(handle, to);
  } else if constexpr (requires { shape.fit(ShapeBox()); }) {
    const auto box = shape.box();
    if (box && isCorner(handle)) shape.fit(box->withCorner(handle, to, even));
  }
}

}  // namespace

const char* handleName(What what) {
  constexpr std::array<const char*, 9> kNames{"middle",   "from",      "to",          "inner",       "outer",
                                              "top_left", "top_right", "bottom_left", "bottom_right"};
  return kNames.at(static_cast<size_t>(what));
}

std::vector<ShapeHandle> handlesOf(const MaskShape& shape) {
  const auto own = std::visit(
      [](const auto& s) -> std::vector<ShapeHandle> {
        if constexpr (requires { s.handles(); }) return s.handles();
        return {};
      },
      shape.shape);
  const auto box = boxOf(shape);
  if (!own.empty() || !box) return own;
  std::vector<ShapeHandle> corners;
  for (const What corner : {What::BottomRight, What::TopLeft, What::TopRight, What::BottomLeft})
    corners.push_back({corner, box->corner(corner)});
  corners.push_back({What::Middle, box->middle()});
  return corners;
}

MaskShape withHandleAt(const MaskShape& shape, What handle, Point to, bool even) {
  if (handle == What::Middle) {
    for (const ShapeHandle& one : handlesOf(shape))
      if (one.what == handle) return movedShape(shape, to[0] - one.at[0], to[1] - one.at[1]);
    return shape;
  }
  MaskShape next = shape;
  std::visit([&](auto& s) { moveHandle(s, handle, to, even); }, next.shape);
  return next;
}

}  // namespace swaplight
