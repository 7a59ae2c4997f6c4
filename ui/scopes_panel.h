#pragma once

#include "ui/scope_plots.h"
#include "ui/scopes_controller.h"

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
