#pragma once

#include <filesystem>
#include <memory>

#include "core/ocio/color_config.h"

namespace swaplight {

// How a program comes to its colour configuration when it starts. Everybody else is given one.

/// That of $OCIO; null where it is not set. Throws InputError that names the file and says what to do where
/// it cannot be used.
[[nodiscard]] std::shared_ptr<const ColorConfig> environmentConfig();

/// That of the file that a session names; empty: the built-in one. Throws InputError that names the file and
/// says what to do.
[[nodiscard]] std::shared_ptr<const ColorConfig> sessionConfig(const std::filesystem::path& file);

/// environmentConfig(), else sessionConfig(). Throws InputError as they do.
[[nodiscard]] std::shared_ptr<const ColorConfig> programConfig(const std::filesystem::path& sessionFile = {});

}  // namespace swaplight
