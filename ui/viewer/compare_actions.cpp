#include "ui/shell/studio_window.h"

namespace swaplight {

void StudioWindow::addCompareActions() {
  using Mode = CompareState::Mode;
  const auto hasSet = [this] { return m_session.set() != nullptr; };
  const auto compare = [&](const char* id, const char* name, const char* keys, const char* tip, Mode mode) {
    m_actions.add({id, name, keys, tip,
                   [this, mode] {
                     CompareState& state = m_view.compare;
                     state.mode = state.mode == mode ? Mode::Off : mode;
                   },
                   hasSet, [this, mode] { return m_view.compare.mode == mode; }});
  };
  compare("compare.wipe", "Wipe", "W",
          "A on one side of a line, B on the other. Drag the line; its end turns it.", Mode::Wipe);
  compare("compare.split", "Split", "Shift+W", "A and B side by side.", Mode::Split);
  compare("compare.difference", "Difference", "D", "The size of A minus B, in linear light.",
          Mode::Difference);
  compare("compare.toggle", "Only B", "T", "Show B instead of A; again: A.", Mode::OnlyB);
  m_actions.add({"compare.off", "Only A", "", "No comparison.", [this] { m_view.compare.mode = Mode::Off; },
                 hasSet, [this] { return m_view.compare.mode == Mode::Off; }});
  m_actions.add({"compare.keep", "Keep this lighting as B", "K",
                 "Compare what you change from here on with the lighting of now.",
                 [this] {
                   m_view.compare.subject = {};
                   m_view.compare.rig = m_editor.document().rig;
                   m_messages.info("B is the lighting of now. W wipes, T toggles.");
                 },
                 hasSet});
  m_actions.add(
      {"compare.center_line", "Centre the wipe's line", "", "Upright, in the middle of the picture.",
       [this] { m_view.compare.x = m_view.compare.y = 0.5, m_view.compare.angleDegrees = 0; }, hasSet});
  m_actions.add({"view.photograph", "Original photograph", "O",
                 "Show the first photograph as it was taken; again: the relit picture.",
                 [this] {
                   using Kind = ViewSubject::Kind;
                   const bool shown = m_view.subject.kind == Kind::Photograph;
                   m_view.subject = shown ? ViewSubject{} : ViewSubject{Kind::Photograph, 0};
                 },
                 [this] { return m_session.set() && m_session.set()->solved->capture.shotCount() > 0; },
                 [this] { return m_view.subject.kind == ViewSubject::Kind::Photograph; }});
  m_actions.add(
      {"view.next_photograph", "Next photograph", "Shift+O", "Show the next photograph.",
       [this] {
         const bool shown = m_view.subject.kind == ViewSubject::Kind::Photograph;
         const int count = m_session.set()->solved->capture.shotCount();
         m_view.subject = {ViewSubject::Kind::Photograph, shown ? (m_view.subject.index + 1) % count : 0};
       },
       [this] { return m_session.set() && m_session.set()->solved->capture.shotCount() > 0; }});
}

}  // namespace swaplight
