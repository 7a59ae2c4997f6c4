#pragma once

#include <fmt/core.h>

#include <array>
#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// Another of the colours that a gel may have had which two swapped photographs do not determine (OpenColor
/// of the solve's report): both photographs are explained equally well by all of them. Acts on both lights,
/// as if the set had been solved with that colour: see edit/apply/gel_mixing.h.
struct UnknownGelOperation {
  enum class Lamps { AsSolved, Exchanged };
  float position = 0;  ///< 0..1: from the colour nearest to the known gel to the farthest
  Lamps lamps = Lamps::AsSolved;
  bool operator==(const UnknownGelOperation&) const = default;

  static constexpr OperationInfo info{
      "unknown_gel", "Unknown gel",
      "Two swapped photographs leave one number of an unknown gel open, from warmer to cooler: chooses it by "
      "eye. A pixel that one lamp alone lights, a grey patch or a third photograph settles it."};
  static constexpr bool kOfAllLights = true;
  static constexpr bool kMixesLights = true;
  static constexpr std::array<const char*, 2> kLampNames{"as_solved", "exchanged"};
  static constexpr std::array<const char*, 2> kLampTitles{"as solved", "the other way round"};
  static constexpr auto fields() {
    return std::tuple{
        numberField("position", &UnknownGelOperation::position, {Scale::Unit::Percent, 0, 1, 0, 1}, "Colour",
                    "Along the colours that the gel may have: the photographs fit equally well. 0 % is most "
                    "like the known gel."),
        choiceField("lamps", &UnknownGelOperation::lamps, kLampNames, "Lamps",
                    "Which lamp had the unknown gel first: that, too, two photographs do not say for sure.",
                    kLampTitles)};
  }
  [[nodiscard]] std::string summary() const { return fmt::format("{:.0f} %", 100 * position); }
};

}  // namespace swaplight
