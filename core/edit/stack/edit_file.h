#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/edit/stack/edit.h"

namespace swaplight {

/// Reads a file of edits ({"format": "swaplight-edits", "version": 1, "new_lights": [...], "edits": [...]})
/// for pictures of the size given. Files that the edits name are relative to the file. Throws InputError that
/// names the file. `warnings`, if there are any: says in them which keys are unknown.
[[nodiscard]] EditStack readEdits(const std::filesystem::path& file, int width, int height,
                                  std::vector<std::string>* warnings = nullptr);

/// Writes such a file. Throws InputError where it cannot be written.
void writeEdits(const EditStack& stack, const std::filesystem::path& file);

}  // namespace swaplight
