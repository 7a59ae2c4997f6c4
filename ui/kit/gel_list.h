#pragma once

#include <optional>
#include <string>

#include "ui/actions/action_table.h"

namespace swaplight {

/// A list of gels under a field that searches it, for a popup. Returns the gel that was chosen in this frame;
/// empty for none, which only a list with `orNone` offers.
[[nodiscard]] std::optional<std::string> gelChoices(const std::string& current, std::string& filter,
                                                    bool orNone = false);
/// The same as a combo, with no gel and the import of more. Returns the gel that was chosen in this frame;
/// empty for none.
[[nodiscard]] std::optional<std::string> gelCombo(const char* id, const std::string& current,
                                                  std::string& filter, const ActionTable& actions);

}  // namespace swaplight
