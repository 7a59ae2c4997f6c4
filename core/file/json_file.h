#pragma once

#include <filesystem>
#include <string>

#include "core/base/json_fwd.h"

namespace swaplight {

/// Reads a JSON file. Throws InputError: one line that names the file and, for a syntax error, line and
/// column.
[[nodiscard]] Json readJson(const std::filesystem::path& file);

/// JSON from text; `name` stands for it in messages. Throws InputError as readJson does.
[[nodiscard]] Json parseJson(const std::string& text, const std::string& name);

/// Writes indented JSON, atomically. Throws InputError where it cannot be written.
void writeJson(const Json& json, const std::filesystem::path& file);

/// JSON as text, in one line or indented. Bytes that are not UTF-8 (the name of a file or folder) become
/// U+FFFD.
[[nodiscard]] std::string jsonText(const Json& json, int indent = -1);

/// A float as the number that a person would write: 0.9, not 0.8999999761581421.
[[nodiscard]] Json jsonNumber(float value);

}  // namespace swaplight
