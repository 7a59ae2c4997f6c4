#pragma once

#include <filesystem>
#include <vector>

#include "ui/actions/action_table.h"
#include "ui/control/session_controller.h"

namespace swaplight {

/// What to do first: shown in the viewer's place while nothing is open.
void drawWelcomePanel(SessionController& session, const ActionTable& actions,
                      const std::vector<std::filesystem::path>& samples);

}  // namespace swaplight
