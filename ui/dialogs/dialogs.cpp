#include "ui/dialogs/dialogs.h"

#include <imgui.h>

#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

bool beginDialog(const char* title, float width) {
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y * 0.4F), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(px(width), 0));
  if (!ImGui::BeginPopupModal(
          title, nullptr,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return false;
  beginTabStops();
  return true;
}

void endDialog() {
  endTabStops();
  ImGui::EndPopup();
}

enum class Answers { ToEnter, ToEscape, ToItself };

bool button(const char* text, const char* mark, const char* tip, Answers to = Answers::ToItself) {
  const float width = px(130);
  const bool clicked = to == Answers::ToEnter    ? defaultButton(text, width, true, tip)
                       : to == Answers::ToEscape ? cancelButton(text, width, tip)
                                                 : ImGui::Button(text, ImVec2(width, 0));
  markItem(mark);
  if (to == Answers::ToItself) tooltip(tip);
  if (clicked) ImGui::CloseCurrentPopup();
  return clicked;
}

}  // namespace

void UnsavedDialog::draw() {
  if (!m_question || !beginDialog("Unsaved work", 460)) return;
  ImGui::TextWrapped("%s has unsaved changes.", m_question->name.c_str());
  ImGui::Dummy(ImVec2(0, px(8)));
  std::function<void()> answer;
  bool answered = false;
  if (button("Save", "unsaved.save", "Save, then go on (Enter)", Answers::ToEnter)) {
    answer = m_question->save;
    answered = true;
  }
  ImGui::SameLine();
  if (button("Discard", "unsaved.discard", "Go on without saving")) {
    answer = m_question->goOn;
    answered = true;
  }
  ImGui::SameLine();
  if (button("Cancel", "unsaved.cancel", "Go back (Escape)", Answers::ToEscape)) {
    answer = m_question->stay;
    answered = true;
  }
  endDialog();
  if (answered) m_question.reset();
  if (answer) answer();
}

void RecoveryDialog::draw(SessionController& session) {
  if (m_dismissed || session.recovered().empty()) return;
  const Recovered newest = session.recovered().front();  // a copy: an answer removes it
  if (!beginDialog("Swaplight ended unexpectedly", 560)) return;
  const std::filesystem::path file = !newest.opening.empty() ? newest.opening : newest.savedAs;
  const std::string name = file.empty() ? "a session without a name" : file.string();
  const bool hasWork = !newest.session.empty();
  if (hasWork)
    ImGui::TextWrapped("Unsaved work from %s can be recovered. At most the last few seconds are lost.",
                       name.c_str());
  else
    ImGui::TextWrapped("It was opening %s, which may be the cause.", name.c_str());
  ImGui::Dummy(ImVec2(0, px(8)));
  bool done = false, opened = false;
  if (hasWork) {
    if (button("Recover", "recovery.recover", "Open it as it was (Enter)", Answers::ToEnter)) {
      session.recover();
      m_dismissed = true;  // what others have left is offered at the next start
    }
    ImGui::SameLine();
  }
  if (!newest.opening.empty()) {
    if (button("Open safely", "recovery.safe", "Open it without its pictures",
               hasWork ? Answers::ToItself : Answers::ToEnter)) {
      session.openWithoutPictures(std::filesystem::path(newest.opening));
      done = opened = true;
    }
    ImGui::SameLine();
  }
  if (button("Discard", "recovery.discard", "Delete what could be recovered")) done = true;
  ImGui::SameLine();
  const bool later =
      button("Later", "recovery.later", "Ask again at the next start (Escape)", Answers::ToEscape);
  endDialog();
  if (later) m_dismissed = true;
  if (done) {
    session.discardRecoveredFiles();
    m_dismissed = opened;  // what others have left is offered after this one, or at the next start
  }
}

}  // namespace swaplight
