#pragma once

#include <array>
#include <functional>
#include <glm/mat3x3.hpp>
#include <vector>

#include "core/image/image.h"
#include "core/view/display/color_cube.h"

namespace swaplight {

/// Brings scene-linear R G B to display code values 0..1, in place: what a display and a view of a colour
/// configuration do. Exact, and too slow for every frame. Called from several threads.
using ViewFunction = std::function<void(ImageSpan)>;

/// The same view as samples, for pictures that must follow the mouse: a matrix or a cube, then a curve a
/// channel. Views that only change primaries and encode (sRGB, Rec.709, P3, raw) become a matrix and exact
/// curves; whatever else (film-like ones) a cube of display-linear colours, encoded by a curve afterwards
/// (sRGB or the power that fits the view best), so that the bend at black is not smeared over a cell.
class BakedView {
 public:
  /// About 40 ms.
  explicit BakedView(const ViewFunction& view);

  /// True where the view is a matrix and curves, to a quarter of an 8-bit code.
  [[nodiscard]] bool exact() const { return m_cube.empty(); }

  /// The first step, in place: three channels of at most ColorCube::kBlock values, kBlock apart.
  void mix(float* rgb, size_t count) const;
  /// The second step: code values, not clamped, for the 65536 half floats in the order of their bits.
  [[nodiscard]] const std::vector<float>& curve(int channel) const {
    return m_curves[static_cast<size_t>(channel)];
  }

 private:
  bool m_mixes = false;  ///< the matrix is not the identity
  glm::mat3 m_matrix{1};
  ColorCube m_cube;
  std::array<std::vector<float>, 3> m_curves;
};

/// The finite value of a half float by its bits: infinities count as the largest, NaN as 0.
[[nodiscard]] float finiteHalf(int bits);

}  // namespace swaplight
