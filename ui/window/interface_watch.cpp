#include "ui/window/interface_watch.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <utility>

namespace swaplight {
namespace {

/// A window takes its size in its second frame, a field its focus in the frame after it was given.
bool underWay(const ImGuiContext& g) {
  if (g.NavMoveSubmitted || g.NavInitRequest || g.NavInitResultId != 0 || g.NavNextActivateId != 0)
    return true;
  return std::any_of(g.Windows.begin(), g.Windows.end(), [](const ImGuiWindow* window) {
    return window->Active &&
           (window->HiddenFramesCanSkipItems > 0 || window->HiddenFramesCannotSkipItems > 0);
  });
}

}  // namespace

InterfaceWatch::Focus InterfaceWatch::focusNow() {
  const ImGuiContext& g = *GImGui;
  Focus focus;
  focus.active = g.ActiveId;
  focus.navigated = g.NavId;
  focus.window = g.NavWindow ? g.NavWindow->ID : 0;
  focus.popup = g.OpenPopupStack.empty() ? 0 : g.OpenPopupStack.back().PopupId;
  focus.popups = g.OpenPopupStack.Size;
  focus.windows = g.WindowsActiveCount;
  focus.typing = g.WantTextInputNextFrame == 1;
  return focus;
}

// Dear ImGui counts frames of fitting itself (AutoFitFramesY), but begins anew every frame with a window that
// is as high as its contents: whether there is anything to fit, the places say.
std::vector<InterfaceWatch::Place> InterfaceWatch::placesNow() {
  std::vector<Place> places;
  for (const ImGuiWindow* window : GImGui->Windows)
    if (window->Active)
      places.push_back({window->ID, window->Pos.x, window->Pos.y, window->Size.x, window->Size.y});
  return places;
}

void InterfaceWatch::frameDrawn() {
  const Focus focus = focusNow();
  std::vector<Place> places = placesNow();
  const bool settled = focus == m_focus && places == m_places && !underWay(*GImGui);
  m_moves = !settled || GImGui->HoveredId != m_hovered;
  m_hovered = GImGui->HoveredId;
  m_focus = focus;
  m_places = std::move(places);
  m_state = {focus.typing, settled};
}

void feedInterface(const InputFrame& input) {
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = static_cast<float>(input.seconds);
  io.MousePos =
      input.pointer ? ImVec2(input.pointer->first, input.pointer->second) : ImVec2(-FLT_MAX, -FLT_MAX);
  std::copy(input.buttons.begin(), input.buttons.end(), io.MouseDown);
  io.MouseWheelH += input.wheelX;
  io.MouseWheel += input.wheelY;
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  for (const int code : input.held)
    if (code >= 0 && code < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[code] = true;
  io.KeyCtrl = input.keyboard.isHeld("Ctrl");
  io.KeyShift = input.keyboard.isHeld("Shift");
  io.KeyAlt = input.keyboard.isHeld("Alt");
  io.KeySuper = input.keyboard.isHeld("Super");
  for (const char32_t character : input.text) io.AddInputCharacter(character);
  if (input.focusLost) io.AddFocusEvent(false);
}

}  // namespace swaplight
