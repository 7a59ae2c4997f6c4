#pragma once

#include <fmt/core.h>

#include <array>
#include <string>

#include "core/color/rgb.h"
#include "core/edit/fields/field.h"
#include "core/edit/operations/blur_operation.h"

namespace swaplight {

/// The light's detected shadows. `amount` 0..1 goes from nothing to everything. Unlike the other edits it
/// acts on the light's contribution, not on beta, and always adds: see edit/apply/shadow_change.h.
struct ShadowOperation {
  enum class Kind {
    Lighten,  ///< fills the shadow with what the light would give there; amount 1 removes it
    Deepen,   ///< takes away what is left in it
    Soften,   ///< widens the penumbra by `radius`
    Sharpen,  ///< makes the penumbra a hard edge
    Recolor,  ///< fills with `color` times what the light would give
  };
  Kind kind = Kind::Lighten;
  float amount = 1;
  int radius = 12;
  Rgb color{1, 1, 1};
  bool operator==(const ShadowOperation&) const = default;

  static constexpr OperationInfo info{"shadow", "Shadows", "Changes the light's own shadows.", false};
  static constexpr bool kUsesShadows = true;
  static constexpr std::array<const char*, 5> kKindNames{"lighten", "deepen", "soften", "sharpen", "recolor"};
  static constexpr std::array<const char*, 5> kKindTitles{"lighten", "deepen", "soften", "sharpen",
                                                          "recolour"};
  static constexpr auto fields() {
    return std::tuple{choiceField("kind", &ShadowOperation::kind, kKindNames, "Shadows",
                                  "What is done to them.", kKindTitles),
                      numberField("amount", &ShadowOperation::amount, {Scale::Unit::Percent, 0, 1, 0, 1},
                                  "Amount", "0 % leaves the shadows as they are."),
                      numberField("radius", &ShadowOperation::radius, kRadiusScale, "Radius",
                                  "How far the shadow's edge spreads, in image pixels.",
                                  [](const ShadowOperation& shadow) { return shadow.kind == Kind::Soften; }),
                      plainField("color", &ShadowOperation::color, "Colour", "Colour that fills the shadows.",
                                 [](const ShadowOperation& shadow) { return shadow.kind == Kind::Recolor; })};
  }
  [[nodiscard]] std::string summary() const {
    const char* name = kKindTitles.at(static_cast<size_t>(kind));
    return kind == Kind::Soften ? fmt::format("{} {} px", name, radius)
                                : fmt::format("{} {:.0f} %", name, 100 * amount);
  }
};

}  // namespace swaplight
