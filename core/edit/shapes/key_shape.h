#pragma once

#include <map>
#include <string>

#include "core/base/json_fwd.h"
#include "core/color/rgb.h"
#include "core/edit/fields/field.h"
#include "core/edit/raster/mask_raster.h"
#include "core/edit/shapes/shape_info.h"
#include "core/set/solved_set.h"

namespace swaplight {

class JsonFields;

/// The matte of a key, as the camera filters chroma-key and luma-key make it of the frame: 1 where the
/// foreground is, 0 on the screen (by luma: 1 where it is bright). It is made of the set under the lights
/// that were on when it was taken, so that it stays where it is when they change.
struct KeyShape {
  enum class By {
    Chroma,  ///< distance from the screen's colour in the plane of Cb and Cr
    Luma,    ///< Rec.601 luma
  };
  By by = By::Chroma;
  Rgb color{.1f, .7f, .2f};      ///< chroma: of the screen; sRGB codes, 0..1
  float from = .12f, to = .22f;  ///< where the matte is 0, and from where on it is 1
  /// What each light is multiplied with, by its name, in the set's colour space; 1 where it is missing.
  std::map<std::string, Rgb> lights;
  float ambient = 1;
  bool operator==(const KeyShape&) const = default;

  static constexpr ShapeInfo info{"key", "key's matte"};
  static constexpr const char* kByNames[] = {"chroma", "luma"};
  static constexpr Scale kCodes{Scale::Unit::Factor, 0, 1, 0, 1};
  static constexpr auto fields() {
    return std::tuple{choiceField("by", &KeyShape::by, kByNames), plainField("color", &KeyShape::color),
                      numberField("from", &KeyShape::from, kCodes), numberField("to", &KeyShape::to, kCodes)};
  }
  void writeMore(Json& json) const;
  void readMore(JsonFields& fields, int width, int height);
  void check(const std::string& where) const;

  /// The frame in sRGB codes, 0..1, where light above 1 is white; then chroma: clamp((d - from) / (to -
  /// from)); luma: smoothstep(from, to).
  [[nodiscard]] MaskRaster draw(const SolvedSet& set) const;
};

}  // namespace swaplight
