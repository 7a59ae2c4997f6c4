#pragma once

#include <string>

#include "ui/actions/action_table.h"

namespace swaplight {

/// One action as a menu's line.
void actionMenuItem(const ActionTable& actions, const std::string& id);
/// One action as a button with an icon; its name and keys as the tooltip.
bool actionButton(const ActionTable& actions, const std::string& id, const char* icon, float side);
/// One action as a button with words.
void actionTextButton(const ActionTable& actions, const std::string& id, const char* text, float width);
/// An action's name, keys and what it does.
[[nodiscard]] std::string actionTip(const Action& action);

}  // namespace swaplight
