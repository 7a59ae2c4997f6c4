#pragma once

#include <CLI/App.hpp>
#include <optional>

#include "core/session/session_file.h"

namespace swaplight {

/// --display, --view and --view-look. `choice` must live as long as the verb.
void addDisplayOptions(CLI::App& verb, DisplayChoice& choice);

/// What the command line asks for, over what the session says.
[[nodiscard]] DisplayChoice displayOver(const std::optional<Session>& session, const DisplayChoice& asked);

}  // namespace swaplight
