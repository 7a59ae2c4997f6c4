#pragma once

#include <array>
#include <string>

#include "core/color/rgb.h"
#include "core/edit/fields/field.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// Another colour of a surface: its reflectance, under all lights alike. Grey stays grey, so that white
/// highlights stay white, and twice the light gives twice the result.
struct RecolorOperation {
  enum class Kind {
    Shift,  ///< of its own hue, saturation and lightness
    Color,  ///< `from` becomes `to`; what is whiter than `from` is taken for a highlight, and kept
  };
  Kind kind = Kind::Shift;
  float hue = 0;         ///< degrees, in Oklab
  float saturation = 1;  ///< times; 0: grey
  float lightness = 1;   ///< times the reflectance
  Rgb from{1}, to{1};    ///< linear light at unit white, > 0 in some channel
  bool operator==(const RecolorOperation&) const = default;

  static constexpr OperationInfo info{
      "recolor", "Recolour",
      "Gives the surfaces in the selection another colour, under all lights alike. White highlights stay."};
  static constexpr std::array<const char*, 2> kKindNames{"shift", "color"};
  static constexpr std::array<const char*, 2> kKindTitles{"shift its colour", "to a colour"};
  static constexpr auto fields() {
    constexpr auto kShifts = [](const RecolorOperation& o) { return o.kind == Kind::Shift; };
    constexpr auto kSets = [](const RecolorOperation& o) { return o.kind == Kind::Color; };
    return std::tuple{
        choiceField("kind", &RecolorOperation::kind, kKindNames, "Recolour",
                    "Shift the colour that is there, or replace one colour by another.", kKindTitles),
        numberField("hue", &RecolorOperation::hue, {Scale::Unit::Degrees, -180, 180, -180, 180}, "Hue",
                    "Turns the hue: red, yellow, green, blue and back to red.", kShifts),
        numberField("saturation", &RecolorOperation::saturation, {Scale::Unit::Percent, 0, 4, 0, 2},
                    "Saturation", "0 % is grey.", kShifts),
        numberField("lightness", &RecolorOperation::lightness, {Scale::Unit::Factor, 0, 16, 0.1F, 3},
                    "Lightness", "How much light the surface reflects, times as much as it does.", kShifts),
        plainField("from", &RecolorOperation::from, "Now",
                   "The surface's present colour: the mean of what was selected.", kSets),
        plainField("to", &RecolorOperation::to, "New", "The colour that it gets.", kSets)};
  }
  [[nodiscard]] std::string summary() const;

  /// A surface that shows this light at unit white, with its new colour: all channels >= 0. `light` >= 0.
  [[nodiscard]] Rgb recolored(const Rgb& light) const;
};

}  // namespace swaplight
