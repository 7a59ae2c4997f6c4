#pragma once

#include "ui/actions/action_table.h"
#include "ui/control/scopes_controller.h"
#include "ui/scopes/scope_plots.h"

namespace swaplight {

/// The scopes below the viewer.
class ScopesPanel {
 public:
  ScopesPanel(const ScopesController::Parts& parts, std::function<void()> wake)
      : m_controller(parts, std::move(wake)) {}
  void draw(const ChosenLights& lights, ScopeOptions& options, const ActionTable& actions);

 private:
  void upload();

  ScopesController m_controller;
  uint64_t m_uploaded = 0;
  ScopeTextures m_textures;
};

}  // namespace swaplight
