#pragma once

#include <array>
#include <vector>

namespace swaplight {

using Point = std::array<float, 2>;  ///< pixels of the picture

/// A place by which a shape is taken hold of.
struct ShapeHandle {
  enum class What {
    Middle,  ///< moves the shape
    From,
    To,  ///< the ends of a linear gradient
    Inner,
    Outer,  ///< the radii of a radial gradient
    TopLeft,
    TopRight,
    BottomLeft,
    BottomRight,  ///< the corners of a box: the opposite one stays
  };
  What what = What::Middle;
  Point at{};
};

/// A box in pixels of the picture.
struct ShapeBox {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] bool contains(Point at) const {
    return at[0] >= x0 && at[0] < x1 && at[1] >= y0 && at[1] < y1;
  }
  [[nodiscard]] Point middle() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
  [[nodiscard]] Point corner(ShapeHandle::What corner) const;
  [[nodiscard]] Point opposite(ShapeHandle::What corner) const;
  /// How much larger the box becomes for its corner to lie next to the point on its diagonal; not below 0.
  [[nodiscard]] float scaleTo(ShapeHandle::What corner, Point to) const;
  /// The box with a corner elsewhere. It does not turn over; `even` keeps its proportions.
  [[nodiscard]] ShapeBox withCorner(ShapeHandle::What corner, Point to, bool even) const;
};

inline constexpr float kLeastSide = 2;  ///< pixels: no box becomes smaller

[[nodiscard]] bool isCorner(ShapeHandle::What what);

/// The point as far away in the next direction that is a multiple of 45 degrees.
[[nodiscard]] Point evenDirection(Point from, Point to);

/// A drag that places a stencil.
struct StencilDrag {
  StencilDrag(Point from, Point to);
  Point from, to;
  float x, y, width, height;  ///< the box between its ends, at least kLeastSide wide and high
  float length;               ///< between its ends
};

}  // namespace swaplight
