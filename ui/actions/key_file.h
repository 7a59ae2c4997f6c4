#pragma once

#include <filesystem>
#include <string>

#include "ui/actions/action_table.h"

namespace swaplight {

/// Gives actions the keys that a file says: a line an action, its id, then its keys; `#` begins a comment. An
/// id alone has no keys. What a file says about actions that do not exist is passed over.
void applyKeyText(ActionTable& actions, const std::string& text);

/// The lines for the actions whose keys are not those they came with.
[[nodiscard]] std::string keyText(const ActionTable& actions);

/// The same from and to a file. A file that is not there says nothing; one that cannot be written throws
/// InputError.
void readKeyFile(ActionTable& actions, const std::filesystem::path& file);
void writeKeyFile(const ActionTable& actions, const std::filesystem::path& file);

}  // namespace swaplight
