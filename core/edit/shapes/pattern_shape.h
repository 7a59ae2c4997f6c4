#pragma once

#include <numbers>
#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/raster/soft_edge.h"
#include "core/edit/shapes/shape_box.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

/// Stripes, checks or dots, as of a gobo in front of a lamp.
struct PatternShape {
  enum class Kind { Stripes, Checks, Dots };
  Kind kind = Kind::Stripes;
  float size = 60;    ///< of one repeat, > 0
  float angle = 0;    ///< degrees, counter-clockwise
  float cover = .5f;  ///< share that is 1, 0..1
  float feather = 2;
  bool operator==(const PatternShape&) const = default;

  static constexpr ShapeInfo info{"pattern", "pattern"};
  static constexpr StencilInfo stencil{
      "Pattern", "A gobo of stripes, checks or dots. Drag one repeat in the direction it should run."};
  static constexpr const char* kKindNames[] = {"stripes", "checks", "dots"};
  static constexpr auto fields() {
    return std::tuple{
        numberField("size", &PatternShape::size, {}), numberField("angle", &PatternShape::angle, {}),
        numberField("cover", &PatternShape::cover, {}), numberField("feather", &PatternShape::feather, {}),
        choiceField("kind", &PatternShape::kind, kKindNames)};
  }
  /// Throws InputError.
  void check(const std::string& where) const;

  [[nodiscard]] float valueAt(float x, float y) const {
    const float turn = angle * std::numbers::pi_v<float> / 180;
    const float u = (x * std::cos(turn) - y * std::sin(turn)) / size;
    const float v = (x * std::sin(turn) + y * std::cos(turn)) / size;
    const float fu = u - std::floor(u);
    const float fv = v - std::floor(v);
    // Distances in repeats from the middle of the covered part.
    const float du = std::abs(fu - .5f) - cover / 2;
    const float dv = std::abs(fv - .5f) - cover / 2;
    switch (kind) {
      case Kind::Stripes:
        return coverage(du * size, feather);
      case Kind::Dots:
        return coverage((lengthOf(fu - .5f, fv - .5f) - cover / 2) * size, feather);
      case Kind::Checks: {
        const float a = coverage(du * size, feather);
        const float b = coverage(dv * size, feather);
        return a * b + (1 - a) * (1 - b);
      }
    }
    return 0;
  }

  static constexpr bool kDragsDirection = true;
  void place(const StencilDrag& drag) {
    size = std::max(drag.length, 4.F);
    angle =
        -std::atan2(drag.to[1] - drag.from[1], drag.to[0] - drag.from[0]) * 180 / std::numbers::pi_v<float>;
  }
};

}  // namespace swaplight
