#include "ui/viewer/viewer_actions.h"

namespace swaplight {

void addCompareActions(ActionTable& actions, ViewerContext& studio) {
  using Mode = CompareState::Mode;
  const auto hasSet = [&studio] { return studio.set() != nullptr; };
  const auto compare = [&](const char* id, const char* name, const char* keys, const char* tip, Mode mode) {
    actions.add({id, name, keys, tip,
                 [&studio, mode] {
                   CompareState& state = studio.view.compare;
                   state.mode = state.mode == mode ? Mode::Off : mode;
                 },
                 hasSet, [&studio, mode] { return studio.view.compare.mode == mode; }});
  };
  compare("compare.wipe", "Wipe", "W",
          "A on one side of a line, B on the other. Drag the line to move it, its end to rotate it.",
          Mode::Wipe);
  compare("compare.split", "Split", "Shift+W", "A and B side by side.", Mode::Split);
  compare("compare.difference", "Difference", "D", "Absolute difference of A and B, in linear light.",
          Mode::Difference);
  compare("compare.toggle", "Show B", "T", "Show B instead of A. Press again for A.", Mode::OnlyB);
  actions.add({"compare.off", "Show A only", "", "Turn the comparison off.",
               [&studio] { studio.view.compare.mode = Mode::Off; }, hasSet,
               [&studio] { return studio.view.compare.mode == Mode::Off; }});
  actions.add({"compare.keep", "Use current lighting as B", "K",
               "Stores the current lighting as B, to compare your changes with.",
               [&studio] {
                 studio.view.compare.subject = {};
                 studio.view.compare.rig = studio.document().rig;
                 studio.messages.info("B is the current lighting. W wipes, T toggles.");
               },
               hasSet});
  actions.add({"compare.center_line", "Centre the wipe", "", "Vertical, in the middle of the picture.",
               [&studio] {
                 studio.view.compare.x = studio.view.compare.y = 0.5, studio.view.compare.angleDegrees = 0;
               },
               hasSet});
  actions.add({"view.photograph", "Original photograph", "O",
               "Show the first photograph as taken. Press again for the relit picture.",
               [&studio] {
                 using Kind = ViewSubject::Kind;
                 const bool shown = studio.view.subject.kind == Kind::Photograph;
                 studio.view.subject = shown ? ViewSubject{} : ViewSubject{Kind::Photograph, 0};
               },
               [&studio] { return studio.set() && studio.set()->solved().capture.shotCount() > 0; },
               [&studio] { return studio.view.subject.kind == ViewSubject::Kind::Photograph; }});
  actions.add({"view.next_photograph", "Next photograph", "Shift+O", "Show the next photograph.",
               [&studio] {
                 const bool shown = studio.view.subject.kind == ViewSubject::Kind::Photograph;
                 const int count = studio.set()->solved().capture.shotCount();
                 studio.view.subject = {ViewSubject::Kind::Photograph,
                                        shown ? (studio.view.subject.index + 1) % count : 0};
               },
               [&studio] { return studio.set() && studio.set()->solved().capture.shotCount() > 0; }});
}

}  // namespace swaplight
