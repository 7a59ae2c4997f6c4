#pragma once

#include <string>

#include "core/base/json_fwd.h"
#include "core/edit/fields/field.h"
#include "core/edit/raster/mask_raster.h"
#include "core/edit/shapes/shape_info.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

class JsonFields;

/// A light's shadows, as detected on the unedited set: 1 - visibility. With `region`, only the
/// connected shadow that holds the pixel x, y.
struct ShadowShape {
  std::string light;
  bool region = false;
  int x = 0, y = 0;  ///< for region
  bool operator==(const ShadowShape&) const = default;

  static constexpr ShapeInfo info{"shadow", "shadows"};
  static constexpr auto fields() { return std::tuple{}; }
  void writeMore(Json& json) const;
  void readMore(JsonFields& fields, int width, int height);

  /// Throws InputError where `region` is asked for and the pixel lies in no shadow.
  [[nodiscard]] MaskRaster draw(const LightShadows& shadows) const;
  /// The whole of one shadow (`region`) and what is nearer to it than to another, up to `zone` pixels away.
  /// For changes that are themselves measured by the visibility. Throws as above.
  [[nodiscard]] MaskRaster drawZone(const LightShadows& shadows, int zone) const;
};

}  // namespace swaplight
