#pragma once

#include "ui/control/scopes_controller.h"
#include "ui/scopes/scope_plots.h"

namespace swaplight {

/// The scopes below the viewer.
class ScopesPanel {
 public:
  explicit ScopesPanel(std::function<void()> wake) : m_controller(std::move(wake)) {}
  void draw(StudioContext& studio);

 private:
  void upload();

  ScopesController m_controller;
  uint64_t m_uploaded = 0;
  ScopeTextures m_textures;
};

}  // namespace swaplight
