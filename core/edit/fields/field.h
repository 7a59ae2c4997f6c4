#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace swaplight {

using PointList = std::vector<std::array<float, 2>>;

/// How far a number goes, and how the studio shows it.
struct Scale {
  enum class Unit { Factor, Percent, Pixels, Count, Degrees, Widths };
  Unit unit = Unit::Pixels;
  double least = -1e6, most = 1e6;        ///< in files; what lies outside is refused
  float sliderLeast = 0, sliderMost = 1;  ///< of the studio's slider
  const char* zero = nullptr;             ///< what 0 means, where it is no number: "far"

  [[nodiscard]] constexpr float within(double value) const {
    return static_cast<float>(std::clamp(value, least, most));
  }
};

/// One value of an edit or of a mask's shape, described once: files, the checks of input and the studio's
/// controls all follow from it.
template <typename Owner, typename Value>
struct Field {
  const char* key;  ///< in files
  Value Owner::*member;
  const char* label;  ///< in the studio
  const char* tip;    ///< in the studio
  Scale scale;        ///< of numbers
  std::span<const char* const>
      choices;  ///< of enumerations, in files: a name stands at its enumerator's place
  std::span<const char* const> titles;  ///< the same in the studio
  bool (*applies)(const Owner&);        ///< nullptr: always; else whether the studio shows it
};

/// A float or an int.
template <typename Owner, typename Value>
constexpr Field<Owner, Value> numberField(const char* key, Value Owner::*member, const Scale& scale,
                                          const char* label = "", const char* tip = "",
                                          std::type_identity_t<bool (*)(const Owner&)> applies = nullptr) {
  return {key, member, label, tip, scale, {}, {}, applies};
}

/// An enumeration.
template <typename Owner, typename Value>
constexpr Field<Owner, Value> choiceField(const char* key, Value Owner::*member,
                                          std::span<const char* const> choices, const char* label = "",
                                          const char* tip = "", std::span<const char* const> titles = {}) {
  static_assert(std::is_enum_v<Value>);
  return {key, member, label, tip, {}, choices, titles.empty() ? choices : titles, nullptr};
}

/// A text, points of a curve or a line, a colour.
template <typename Owner, typename Value>
constexpr Field<Owner, Value> plainField(const char* key, Value Owner::*member, const char* label = "",
                                         const char* tip = "",
                                         std::type_identity_t<bool (*)(const Owner&)> applies = nullptr) {
  return {key, member, label, tip, {}, {}, {}, applies};
}

/// Calls visit(field, value) for each of Owner::fields(), in their order.
template <typename Owner, typename Visit>
void forEachField(Owner& owner, const Visit& visit) {
  std::apply([&](const auto&... field) { (visit(field, owner.*field.member), ...); },
             std::remove_const_t<Owner>::fields());
}

}  // namespace swaplight
