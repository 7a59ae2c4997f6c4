#pragma once

#include <compare>
#include <optional>
#include <string>

#include "core/ocio/color_grade.h"

namespace swaplight {

class ColorConfig;

/// How a picture is brought to a monitor, by names of an OpenColorIO configuration. Empty names stand for the
/// configuration's own. The grade comes first, then looks, view and display.
struct DisplayChoice {
  std::string display;
  std::string view;
  /// The looks in place of the view's own, as OpenColorIO writes them: names in the order of their working,
  /// parted by commas, "-" before one that is undone ("+warm, -bleach"), "|" before what to do where a look's
  /// file is missing. Empty: none at all. Without a value: what the view says.
  std::optional<std::string> look = {};
  /// Without a value: nothing is said, and none is applied.
  std::optional<ColorGrade> grade = {};

  auto operator<=>(const DisplayChoice&) const = default;  // NOLINT(modernize-use-nullptr)
  /// Says nothing that a picture shows.
  [[nodiscard]] bool empty() const { return display.empty() && view.empty() && !look && !actingGrade(); }
  /// The grade where it changes anything, or nullptr.
  [[nodiscard]] const ColorGrade* actingGrade() const { return grade && !grade->idle() ? &*grade : nullptr; }
  [[nodiscard]] DisplayChoice withoutGrade() const { return {display, view, look}; }
  /// This choice where it names a display or a view; else the other one, with this one's look if it has one.
  /// Its grade is this one's if it has one.
  [[nodiscard]] DisplayChoice over(const DisplayChoice& other) const;
};

/// The choice as far as the configuration has it: its default display and view where it lacks one of them,
/// the view's own look where it lacks a look.
[[nodiscard]] DisplayChoice displayWithin(const ColorConfig& config, const DisplayChoice& choice);
/// The choice with the configuration's own names in the place of empty ones.
[[nodiscard]] DisplayChoice namedDisplay(const ColorConfig& config, DisplayChoice choice);

/// "Monitor · Film · warm", for people: the display's name once where its view has the same.
[[nodiscard]] std::string displayWords(const DisplayChoice& choice);

/// A look by what a person types: "none" for no look.
[[nodiscard]] std::string lookFromText(const std::string& text);

}  // namespace swaplight
