#include "ui/window/window.h"

#include <imgui.h>

namespace swaplight {

void Window::nextInput() {
  if (!m_input.empty()) requestFrames();
  m_input.next(m_watch.state(), InputQueue::Clock::now());
}

void Window::frameDone() {
  m_framesWanted = std::max(0, m_framesWanted - 1);
  m_watch.frameDrawn();
  if (m_watch.moves()) requestFrames(2);
}

void Window::applyPretendedMouse() const {
  if (!m_pretended.on) return;
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = ImVec2(m_pretended.x, m_pretended.y);
  io.MouseDown[ImGuiMouseButton_Left] = m_pretended.down;
  io.MouseDown[ImGuiMouseButton_Right] = m_pretended.right;
}

}  // namespace swaplight
