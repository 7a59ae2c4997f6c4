#include "ui/window/window.h"

#include <imgui.h>

namespace swaplight {

void Window::applyPretendedMouse() const {
  if (!m_pretended.on) return;
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(m_pretended.x, m_pretended.y);
  io.MouseDown[ImGuiMouseButton_Left] = m_pretended.down;
  io.MouseDown[ImGuiMouseButton_Right] = m_pretended.right;
}

}  // namespace swaplight
