#include "ui/desk/cue_player.h"

#include <gmock/gmock.h>

#include "core/relight/level.h"
#include "core/relight/live_level.h"
#include "tests/support/studio_parts.h"
#include "ui/desk/cue_edit.h"

namespace swaplight {
namespace {

using test::StudioParts;
using testing::HasSubstr;

/// Two cues of three lights: all on, and all two stops down. Cue 1 stands.
struct Show {
  Show() {
    studio.open(test::smallSet(3, 8, 8));
    cues.update(studio.lights);
    recordCueLine(studio.lights, "1");
    for (size_t light = 0; light < 3; ++light)
      editLights(studio.chosen, light, "dim", [](LightSetting& setting) { setting.stops = -2; });
    recordCueLine(studio.lights, "2");
    cues.go(studio.lights, "1 in 0");
    cues.update(studio.lights);
  }
  [[nodiscard]] double level(size_t light) const {
    return liveLevel(studio.editor.document().rig, light).level;
  }
  [[nodiscard]] size_t steps() const { return studio.editor.history().steps().size(); }
  /// Goes to cue 2 until some of the way is gone.
  void goPartly(const char* where = "2 in 0.4") {
    cues.go(studio.lights, where);
    until([&] { return level(1) < .95; });
  }
  template <typename Condition>
  void until(const Condition& holds) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!holds()) {
      ASSERT_LT(std::chrono::steady_clock::now(), patience);
      cues.update(studio.lights);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  void finish() {
    until([&] { return !cues.fading(); });
    cues.update(studio.lights);
  }

  StudioParts studio;
  CuePlayer cues;
};

TEST(CuePlayer, ALightThatIsTouchedLeavesTheFadeAndTheOthersFinishIt) {
  Show show;
  const size_t before = show.steps();
  show.goPartly();
  editLevel(show.studio.chosen, 0, 1.5);
  show.finish();
  EXPECT_NEAR(show.level(0), 1.5, 1e-4);
  EXPECT_NEAR(show.level(1), .25, 1e-4);
  EXPECT_NEAR(show.level(2), .25, 1e-4);
  EXPECT_EQ(show.cues.current(), 200);
  EXPECT_EQ(show.studio.said(), "");
  // What was there when it was touched, the touch, the rest of the fade.
  EXPECT_EQ(show.steps(), before + 3);
  show.studio.editor.undo();
  show.cues.update(show.studio.lights);
  EXPECT_NEAR(show.level(0), 1.5, 1e-4);
  EXPECT_GT(show.level(1), .25);
  EXPECT_EQ(show.cues.current(), 100) << "cue 2 does not stand there";
  show.studio.editor.undo();
  show.studio.editor.undo();
  show.cues.update(show.studio.lights);
  for (size_t light = 0; light < 3; ++light) EXPECT_NEAR(show.level(light), 1, 1e-4);
  show.studio.editor.goTo(show.steps() - 1);
  show.cues.update(show.studio.lights);
  EXPECT_NEAR(show.level(1), .25, 1e-4);
  EXPECT_EQ(show.cues.current(), 200);
}

TEST(CuePlayer, OtherLightsFadeOnWhileALightIsDraggedAndTheDragIsOneStep) {
  Show show;
  const size_t before = show.steps();
  show.goPartly("2 in 0.8");
  previewLevel(show.studio.chosen, 0, 1.5);
  const double begun = show.level(1);
  show.until([&] { return show.level(1) < begun - .1; });
  previewLevel(show.studio.chosen, 0, 1.75);
  EXPECT_TRUE(show.studio.editor.inGesture());
  EXPECT_FALSE(show.cues.holdsGesture(show.studio.editor));
  EXPECT_EQ(show.steps(), before + 1) << "what the fade had done before the hand came";
  show.studio.editor.commit();
  show.finish();
  EXPECT_NEAR(show.level(0), 1.75, 1e-4);
  EXPECT_NEAR(show.level(1), .25, 1e-4);
  EXPECT_EQ(show.steps(), before + 3);
}

TEST(CuePlayer, AFadeThatEndsInADragLeavesItsStepOpen) {
  Show show;
  const size_t before = show.steps();
  show.goPartly();
  previewLevel(show.studio.chosen, 0, 1.5);
  show.finish();
  EXPECT_TRUE(show.studio.editor.inGesture());
  EXPECT_EQ(show.steps(), before + 1);
  EXPECT_NEAR(show.level(1), .25, 1e-4);
  EXPECT_EQ(show.cues.current(), 200);
}

TEST(CuePlayer, WhoeverEditsOrTakesEveryLightStopsTheFadeAndItIsSaid) {
  Show edited;
  edited.goPartly("2 in 60");
  Edit edit;
  edit.name = "gain";
  edited.studio.append(edit);
  edited.cues.update(edited.studio.lights);
  EXPECT_FALSE(edited.cues.fading());
  EXPECT_THAT(edited.studio.said(), HasSubstr("Cue 2 Cue 2 stopped at "));
  EXPECT_EQ(edited.cues.current(), 100) << "cue 2 does not stand";

  Show taken;
  taken.goPartly("2 in 60");
  for (size_t light = 0; light < 3; ++light) editLevel(taken.studio.chosen, light, 1.5);
  taken.cues.update(taken.studio.lights);
  EXPECT_FALSE(taken.cues.fading());
  EXPECT_THAT(taken.studio.said(), HasSubstr("stopped at "));
}

TEST(CuePlayer, AnUndoTakesTheWholeFadeBack) {
  Show show;
  const size_t before = show.steps();
  show.goPartly("2 in 60");
  show.studio.editor.undo();
  show.cues.update(show.studio.lights);
  EXPECT_FALSE(show.cues.fading());
  EXPECT_EQ(show.steps(), before);
  EXPECT_NEAR(show.level(1), 1, 1e-4);
  EXPECT_EQ(show.cues.current(), 100);
  EXPECT_EQ(show.studio.said(), "");
}

}  // namespace
}  // namespace swaplight
