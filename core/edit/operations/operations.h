#pragma once

#include <concepts>
#include <string>
#include <variant>

#include "core/edit/operations/beta_map_operation.h"
#include "core/edit/operations/blur_operation.h"
#include "core/edit/operations/curve_operation.h"
#include "core/edit/operations/fill_operation.h"
#include "core/edit/operations/gain_operation.h"
#include "core/edit/operations/invert_operation.h"
#include "core/edit/operations/move_operation.h"
#include "core/edit/operations/place_operation.h"
#include "core/edit/operations/recolor_operation.h"
#include "core/edit/operations/shadow_operation.h"
#include "core/edit/operations/sharpen_operation.h"
#include "core/edit/operations/shine_operation.h"
#include "core/edit/operations/size_operation.h"
#include "core/edit/operations/spread_operation.h"
#include "core/edit/operations/turn_operation.h"
#include "core/edit/operations/unknown_gel_operation.h"

namespace swaplight {

// Light edits, what each does to beta, a light's share of the pixel. Beta is measured in the set as solved: 1
// is all of the sum at unit white at that pixel. A light edit is a value struct in a file of its own, with
//
//   static constexpr OperationInfo info           its names
//   static constexpr auto fields()                its values: files, checks and the studio's controls
//   void targetRow(const BetaRow&, float*) const  what it wants beta to be; what is below 0 becomes 0
//   or LampChange lampChange() const              what it does to the light's lamp
//   or float highlightTimes() const               what it multiplies the light's highlights by
//   or Rgb recolored(const Rgb&) const            what it makes of a surface's colour, under all lights
//
// and, where it needs them,
//
//   int reach() const                       pixels around it that a pixel looks at: fills BetaRow::blurred
//
//   std::vector<float> tabulate() const     made once for all rows: fills BetaRow::table
//
//   std::string summary() const             a few words for the list of edits, instead of its name
//
//   static T initial()                      what the studio starts with, instead of T{}
//
//   handle(const LampInHand&), dragTo(const LampInHand&, const PlanePoint&)  of a lamp that is dragged in the
//   picture
//
//   static constexpr bool kSwapsTwoLights   of two lights: they change places
//
//   static constexpr bool kOfAllLights      there is nothing to choose
//
//   static constexpr bool kMixesLights      what a light becomes depends on the other lights
//
//   static constexpr bool kUsesShadows      it needs to know the lights' shadows
//
// and it is listed here. Whatever handles edits visits the list, so that one that is not handled does not
// compile.

using Operation = std::variant<FillOperation, GainOperation, CurveOperation, InvertOperation, BlurOperation,
                               SharpenOperation, BetaMapOperation, ShadowOperation, MoveOperation,
                               TurnOperation, SpreadOperation, SizeOperation, PlaceOperation, ShineOperation,
                               RecolorOperation, UnknownGelOperation>;

/// Says what it wants beta to be. All edits but those of shadows, lamps, highlights, surfaces and unknown
/// gels.
template <typename T>
concept BetaOperation = requires(const T& operation, const BetaRow& row, float* target) {
  operation.targetRow(row, target);
};

/// Says what it does to the light's lamp: acts on the contribution, and always adds.
template <typename T>
concept LampOperation = requires(const T& operation) {
  { operation.lampChange() } -> std::same_as<LampChange>;
};

/// Says what becomes of the light's highlights: acts on the contribution, and always adds.
template <typename T>
concept HighlightOperation = requires(const T& operation) {
  { operation.highlightTimes() } -> std::same_as<float>;
};

/// Its lamp can be dragged in the picture.
template <typename T>
concept DraggedOperation = requires(T& operation, const LampInHand& held, const PlanePoint& place) {
  { operation.handle(held) } -> std::same_as<PlanePoint>;
  operation.dragTo(held, place);
};
/// The same, by a ring around the middle of what it lights.
template <typename T>
concept RingOperation = DraggedOperation<T> && requires {
  requires T::kHeldByRing;
};

/// What it does to its light's lamp: nothing, for edits that are not of lamps.
[[nodiscard]] inline LampChange lampChangeOf(const Operation& operation) {
  return std::visit(
      []<typename T>(const T& one) {
        if constexpr (LampOperation<T>)
          return one.lampChange();
        else
          return LampChange();
      },
      operation);
}

/// Says what it makes of a surface's colour: acts on the contributions of all lights and on ambient light.
template <typename T>
concept SurfaceOperation = requires(const T& operation, const Rgb& light) {
  { operation.recolored(light) } -> std::same_as<Rgb>;
};

template <typename T>
concept LightOperation = std::equality_comparable<T> && std::default_initializable<T> && requires {
  { T::info } -> std::same_as<const OperationInfo&>;
  T::fields();
};

/// Calls visit(T) with a value of each edit as the studio starts with it, in the list's order.
template <typename Visit>
void forEachOperation(const Visit& visit) {
  const auto one = [&]<typename T>(std::type_identity<T>) {
    static_assert(LightOperation<T>);
    if constexpr (requires { T::initial(); })
      visit(T::initial());
    else
      visit(T{});
  };
  [&]<typename... T>(std::type_identity<std::variant<T...>>) {
    (one(std::type_identity<T>{}), ...);
  }(std::type_identity<Operation>{});
}

/// Its name in files: fill, gain, curve ...
[[nodiscard]] std::string operationName(const Operation& operation);
/// What the list of edits says of it: its name, or its values in short.
[[nodiscard]] std::string operationSummary(const Operation& operation);
/// How many pixels around it a pixel looks; 0 for most.
[[nodiscard]] int operationReach(const Operation& operation);
/// Whether it acts on beta, so that other lights may share: all but those of shadows, lamps, highlights,
/// surfaces and unknown gels.
[[nodiscard]] bool actsOnBeta(const Operation& operation);
/// Whether it acts on all lights: there is none to choose. Those of surfaces and unknown gels, which also
/// change the set at unit white.
[[nodiscard]] bool actsOnAllLights(const Operation& operation);
/// Whether it needs to know the lights' shadows.
[[nodiscard]] bool usesShadows(const Operation& operation);
/// Whether it needs to know the lights' highlights.
[[nodiscard]] bool usesHighlights(const Operation& operation);
/// Whether two lights with it change places.
[[nodiscard]] bool swapsTwoLights(const Operation& operation);
/// Whether what a light becomes depends on the other lights, whatever is to happen to them.
[[nodiscard]] bool mixesLights(const Operation& operation);

}  // namespace swaplight
