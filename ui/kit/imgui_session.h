#pragma once

#include <imgui.h>

namespace swaplight {

/// Dear ImGui's context, as long as it lives.
class ImGuiSession {
 public:
  ImGuiSession() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // panels are kept in a file of our own
    io.ConfigWindowsMoveFromTitleBarOnly = true;
  }
  ImGuiSession(const ImGuiSession&) = delete;
  ImGuiSession& operator=(const ImGuiSession&) = delete;
  ~ImGuiSession() { ImGui::DestroyContext(); }
};

}  // namespace swaplight
