#pragma once

namespace swaplight {

/// CIE 1976 L*a*b*: L in 0..100, a and b about -128..128. White point D65.
struct Lab {
  double L = 0;
  double a = 0;
  double b = 0;
};

/// Linear Rec.709 (clipped to 0..1, as a display would) -> XYZ (D65, white = 1) -> Lab.
/// A component that is not a number gives a Lab that is not a number.
[[nodiscard]] Lab labFromLinearRec709(double r, double g, double b);

}  // namespace swaplight
