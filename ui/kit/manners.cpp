#include "ui/kit/manners.h"

#include <imgui_internal.h>

#include <utility>

#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

struct Reached {
  ImGuiID first = 0;          ///< where a dialog or list that was opened has put the keyboard by itself
  ImGuiID item = 0;           ///< to which Tab or an arrow has led
  bool landsOnFirst = false;  ///< the first Tab leads to where the keyboard was put
  bool takesEnter = false;    ///< Enter presses it in this frame
};

Reached& reached() {
  static Reached instance;  // one interface, as Dear ImGui has it
  return instance;
}

bool keyPressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false);
}

bool enterPressed() {
  return keyPressed(ImGuiKey_Enter) || keyPressed(ImGuiKey_KeyPadEnter);
}

/// Before the frame in which Dear ImGui hears of it.
bool goesDown(ImGuiKey key) {
  const ImGuiIO& io = ImGui::GetIO();
  const int index = io.KeyMap[key];
  return index >= 0 && io.KeysDown[index] && io.KeysDownDuration[index] < 0;
}

bool drawnOnTop() {
  const ImGuiContext& g = *GImGui;
  return !g.OpenPopupStack.empty() && g.CurrentWindow &&
         g.OpenPopupStack.back().Window == g.CurrentWindow->RootWindow;
}

bool isModal(const ImGuiPopupData& popup) {
  return popup.Window && (popup.Window->Flags & ImGuiWindowFlags_Modal) != 0;
}

}  // namespace

int openPopups() {
  return GImGui->OpenPopupStack.Size;
}

bool closeTopList() {
  ImGuiContext& g = *GImGui;
  if (g.OpenPopupStack.empty() || isModal(g.OpenPopupStack.back())) return false;
  ImGui::ClosePopupToLevel(g.OpenPopupStack.Size - 1, true);
  return true;
}

void mannersBeforeFrame() {
  ImGuiContext& g = *GImGui;
  // Dear ImGui 1.86 keeps a field's undo after the field is left, and puts it to whatever text is there when
  // it is come back to: beyond the end of a shorter one.
  if (g.ActiveId != g.InputTextState.ID) g.InputTextState.ID = 0;
  ImGuiIO& io = ImGui::GetIO();
  // In the panels letters, arrows and Space are keys of actions.
  if (popupOpen())
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  else
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  Reached& now = reached();
  if (g.NavInitResultId != 0) now.first = g.NavInitResultId;
  if (!popupOpen()) now.item = 0;
  const bool list = popupOpen() && !isModal(g.OpenPopupStack.back());
  const bool there = g.NavId != 0 && !g.NavDisableHighlight && g.ActiveId == 0 && !io.WantTextInput;
  now.takesEnter = popupOpen() && there && (list || g.NavId == now.item);
  // Dear ImGui presses by Space alone.
  const int space = io.KeyMap[ImGuiKey_Space];
  if (now.takesEnter && space >= 0 && (goesDown(ImGuiKey_Enter) || goesDown(ImGuiKey_KeyPadEnter)))
    io.KeysDown[space] = true;
}

void mannersFrame() {
  ImGuiContext& g = *GImGui;
  Reached& now = reached();
  const bool tabbing = (g.NavMoveFlags & ImGuiNavMoveFlags_Tabbing) != 0;
  const bool tabs = g.NavMoveScoringItems && tabbing;
  if (!popupOpen()) {
    // Tab is the key of an action, and goes from field to field only where one is being typed into.
    if (tabs && g.ActiveId == 0) ImGui::NavMoveRequestCancel();
    return;
  }
  // Dear ImGui 1.86 begins anew where nothing is being typed into: go on from there instead, unless the
  // keyboard was only put there when the dialog was opened.
  const bool unseen = g.NavId == now.first && g.NavDisableHighlight;
  const bool landed = std::exchange(now.landsOnFirst, tabs && g.NavTabbingDir == 0 && unseen);
  if (tabs && g.NavTabbingDir == 0 && g.NavId != 0 && !unseen) g.NavTabbingDir = +1;
  const bool moved = g.NavJustMovedToId != 0 && (g.NavMoveFlags & ImGuiNavMoveFlags_FocusApi) == 0;
  if (!moved && !landed) return;
  // It shows where it has come to, also where there is nothing to be typed.
  now.item = g.NavId;
  g.NavDisableHighlight = false;
  g.NavDisableMouseHover = true;
}

void beginTabStops() {
  ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);
}

void endTabStops() {
  ImGui::PopItemFlag();
}

void restartTabRound() {
  ImGui::NavInitWindow(GImGui->CurrentWindow, true);
}

void beginNoTabStops() {
  ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, true);
  ImGui::PushItemFlag(ImGuiItemFlags_NoNavDefaultFocus, true);  // from where Tab would not go on
}

void endNoTabStops() {
  ImGui::PopItemFlag();
  ImGui::PopItemFlag();
}

void joinTabRound() {
  ImGuiWindow* part = GImGui->CurrentWindow;
  if (!part->ParentWindow) return;
  part->Flags |= ImGuiWindowFlags_NavFlattened;
  part->RootWindowForNav = part->ParentWindow->RootWindowForNav;
}

bool keyboardIsHere() {
  return ImGui::GetItemID() != 0 && ImGui::GetItemID() == GImGui->NavId && !GImGui->NavDisableHighlight;
}

bool pressedByEnter() {
  return reached().takesEnter && enterPressed();
}

bool dialogAccepted() {
  if (!drawnOnTop() || reached().takesEnter || !enterPressed()) return false;
  // A press answers one dialog, and not another one that the answer opens.
  static struct {
    int frame = -1;
    ImGuiID dialog = 0;
  } answered;
  const ImGuiID dialog = ImGui::GetCurrentWindow()->ID;
  if (answered.frame == ImGui::GetFrameCount()) return answered.dialog == dialog;
  answered = {ImGui::GetFrameCount(), dialog};
  return true;
}

bool dialogCancelled() {
  return drawnOnTop() && keyPressed(ImGuiKey_Escape);
}

bool defaultButton(const char* label, float width, bool enabled, const char* tip) {
  ImGui::BeginDisabled(!enabled);
  const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(kAccent);
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(accent.x, accent.y, accent.z, 0.62F));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImVec4(accent.x, accent.y, accent.z, 0.8F));
  const bool clicked = ImGui::Button(label, ImVec2(width, 0));
  ImGui::PopStyleColor(2);
  ImGui::EndDisabled();
  tooltip(tip);
  return clicked || (enabled && dialogAccepted());
}

bool cancelButton(const char* label, float width, const char* tip) {
  const bool clicked = ImGui::Button(label, ImVec2(width, 0));
  tooltip(tip);
  return clicked || dialogCancelled();
}

}  // namespace swaplight
