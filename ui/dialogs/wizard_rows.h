#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace swaplight {

/// A light's colour in a lighting, as it is being typed.
struct WizardCell {
  std::string text;
  bool guessed = false;
};

/// A line of the wizard's table: the photographs of one lighting, several of a bracket, or some that are left
/// out.
struct WizardRow {
  std::vector<size_t> photographs;  ///< by their places in the folder
  bool used = true;
  std::vector<WizardCell> cells = {};  ///< one a light

  [[nodiscard]] size_t first() const { return photographs.front(); }
};

/// The photographs that are used, in their order.
[[nodiscard]] std::vector<size_t> usedPhotographs(const std::vector<WizardRow>& rows);

/// The rows with `length` photographs to each that is used; what is left out stays in rows of its own. A row
/// keeps the cells that its first photograph had. `length` divides the number of those that are used.
[[nodiscard]] std::vector<WizardRow> regrouped(const std::vector<WizardRow>& rows, size_t length);

}  // namespace swaplight
