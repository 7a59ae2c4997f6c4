#pragma once

#include <optional>
#include <string>

#include "ui/action_table.h"

namespace swaplight {

/// A list of gels that is searched by typing. Returns the gel that was chosen in this frame; empty for none.
[[nodiscard]] std::optional<std::string> gelCombo(const char* id, const std::string& current,
                                                  std::string& filter, const ActionTable& actions);

}  // namespace swaplight
