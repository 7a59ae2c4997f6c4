#pragma once

#include "core/base/json_fwd.h"
#include "core/edit/fields/field.h"
#include "core/edit/raster/mask_raster.h"
#include "core/edit/shapes/shape_info.h"
#include "core/set/solved_set.h"

namespace swaplight {

class JsonFields;

/// What looks like one place in the set as solved.
struct SimilarShape {
  enum class By {
    Color,  ///< of the sum at unit white
    Share,  ///< the lights' betas
  };
  By by = By::Color;
  int x = 0, y = 0;       ///< the place
  float tolerance = .1f;  ///< the largest difference that counts as alike, 0..1
  bool connected = true;  ///< only what hangs together with the place
  bool operator==(const SimilarShape&) const = default;

  static constexpr ShapeInfo info{"similar", "similar"};
  static constexpr const char* kByNames[] = {"color", "share"};
  static constexpr auto fields() {
    return std::tuple{numberField("tolerance", &SimilarShape::tolerance, {}),
                      choiceField("by", &SimilarShape::by, kByNames)};
  }
  void writeMore(Json& json) const;
  void readMore(JsonFields& fields, int width, int height);

  /// Each pixel averaged with its neighbours (3 x 3) against the mean of 5 x 5 at the place. By colour: the
  /// largest difference of the cube roots of R, G, B of the sum at unit white, which are about as the eye
  /// sees them; by share: the largest difference of a light's beta. Specks of a few pixels are left out.
  /// Throws InputError where the place is outside.
  [[nodiscard]] MaskRaster draw(const SolvedSet& set) const;
};

}  // namespace swaplight
