#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/edit/mask/mask_raster.h"
#include "core/edit/mask/paint.h"

namespace swaplight {

// Where an edit acts, 0..1. All lengths are pixels of the picture; feather is the width over which an edge
// falls from 1 to 0, half of it on either side.

struct RectangleShape {
  float x = 0, y = 0, width = 100, height = 100, feather = 0;
  bool operator==(const RectangleShape&) const = default;
};
struct EllipseShape {
  float x = 0, y = 0, radiusX = 50, radiusY = 50, feather = 0;  ///< x and y: the centre
  bool operator==(const EllipseShape&) const = default;
};
/// The inside of a closed line (even-odd).
struct PolygonShape {
  std::vector<std::array<float, 2>> points;
  float feather = 0;
  bool operator==(const PolygonShape&) const = default;
};
/// 1 before the first point, 0 behind the second, smooth between.
struct LinearGradientShape {
  float x0 = 0, y0 = 0, x1 = 100, y1 = 0;
  bool operator==(const LinearGradientShape&) const = default;
};
/// 1 within the inner radius, 0 outside the outer, smooth between.
struct RadialGradientShape {
  float x = 0, y = 0, inner = 0, outer = 100;
  bool operator==(const RadialGradientShape&) const = default;
};
/// Stripes, checks or dots, as of a gobo in front of a lamp.
struct PatternShape {
  enum class Kind { Stripes, Checks, Dots };
  Kind kind = Kind::Stripes;
  float size = 60;    ///< of one repeat, > 0
  float angle = 0;    ///< degrees, counter-clockwise
  float cover = .5f;  ///< share that is 1, 0..1
  float feather = 2;
  bool operator==(const PatternShape&) const = default;
};
struct TextShape {
  std::string text;
  float x = 0, y = 0;  ///< the left end of the baseline
  float height = 100;  ///< of a line
  float feather = 0;
  bool operator==(const TextShape&) const = default;
};
/// A picture's brightness (luminance of the code values; alpha multiplied in), stretched over a rectangle. 0
/// around it.
struct PictureShape {
  std::string file;
  float x = 0, y = 0, width = 0, height = 0;  ///< width or height 0: the picture's own size
  bool operator==(const PictureShape&) const = default;
};
/// What the brush has left.
struct PaintShape {
  std::shared_ptr<const Painting> painting;
  bool operator==(const PaintShape& other) const;
};
/// A light's shadows, as detected on the unedited set: 1 - visibility. With `region`, only the
/// connected shadow that holds the pixel x, y.
struct ShadowShape {
  std::string light;
  bool region = false;
  int x = 0, y = 0;  ///< for region
  bool operator==(const ShadowShape&) const = default;
};

/// What looks like one place in the set as solved: see selection_drawing.h.
struct SimilarShape {
  enum class By {
    Color,  ///< in the all-white picture
    Share,  ///< in the lights' proportions
  };
  By by = By::Color;
  int x = 0, y = 0;       ///< the place
  float tolerance = .1f;  ///< the largest difference that counts as alike, 0..1
  bool connected = true;  ///< only what hangs together with the place
  bool operator==(const SimilarShape&) const = default;
};
struct SelectionPart;
/// Parts that are put together, one after the other, and softened: what a person has selected.
struct SelectionShape {
  std::shared_ptr<const std::vector<SelectionPart>> parts;  ///< never nullptr
  float feather = 0;
  bool operator==(const SelectionShape& other) const;
};

struct MaskShape {
  std::variant<RectangleShape, EllipseShape, PolygonShape, LinearGradientShape, RadialGradientShape,
               PatternShape, TextShape, PictureShape, PaintShape, ShadowShape, SimilarShape, SelectionShape>
      shape;
  bool invert = false;
  bool operator==(const MaskShape&) const = default;
};

struct SelectionPart {
  enum class Combine { Add, Subtract, Intersect };
  MaskShape shape;
  Combine how = Combine::Add;
  bool operator==(const SelectionPart&) const = default;
};

/// Shapes multiplied with each other: each restricts the others. Without a shape: everywhere.
using Mask = std::vector<MaskShape>;

[[nodiscard]] Json jsonFromMask(const Mask& mask);
/// Paintings are replayed in the size given. Throws InputError.
[[nodiscard]] Mask maskFromJson(const Json& json, int width, int height, const std::string& where);

}  // namespace swaplight
