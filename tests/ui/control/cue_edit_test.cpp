#include "ui/desk/cue_edit.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/session/version.h"
#include "tests/support/studio_parts.h"
#include "ui/control/look_edit.h"

namespace swaplight {
namespace {

using test::StudioParts;
using testing::HasSubstr;

void openLit(StudioParts& studio) {
  studio.open(test::smallSet(2, 8, 8));
}

void dim(StudioParts& studio, float stops) {
  editLights(studio.chosen, 0, "dim", [&](LightSetting& light) { light.stops = stops; });
}

TEST(CueEdit, RecordingIsOneStep) {
  StudioParts studio;
  openLit(studio);
  const size_t before = studio.editor.history().steps().size();
  EXPECT_EQ(recordCueLine(studio.lights, ""), 100);
  dim(studio, -1);
  EXPECT_EQ(recordCueLine(studio.lights, "cue 2.5 time 4 follow 1"), 250);
  const Document& show = studio.editor.document();
  ASSERT_EQ(show.cues.size(), 2U);
  EXPECT_EQ(show.cues[1], (Cue{250, "Cue 2.5", 4, 1.F}));
  EXPECT_EQ(studio.editor.history().steps().size(), before + 3);
  studio.editor.undo();
  EXPECT_EQ(studio.editor.document().cues.size(), 1U);
  EXPECT_EQ(studio.editor.document().looks.size(), 1U);
}

TEST(CueEdit, WhatIsRefusedChangesNothing) {
  StudioParts studio;
  openLit(studio);
  recordCueLine(studio.lights, "");
  const uint64_t revision = studio.editor.revision();
  EXPECT_THROW(recordCueLine(studio.lights, "2 time soon"), InputError);
  EXPECT_THROW(recordCueLine(studio.lights, "night"), InputError);
  EXPECT_THROW(runCueLine(studio.lights, "7 time 4"), InputError);
  EXPECT_EQ(studio.editor.revision(), revision);
}

TEST(CueEdit, LinesAreStepsNamedAsTyped) {
  StudioParts studio;
  openLit(studio);
  recordCueLine(studio.lights, "");
  EXPECT_EQ(runCueLine(studio.lights, "1 time 4 follow 2"), "Cue 1");
  EXPECT_EQ(studio.editor.document().cues[0], (Cue{100, "Cue 1", 4, 2.F}));
  EXPECT_EQ(studio.editor.history().steps().back().name, "Cue 1 time 4 follow 2");
  studio.editor.undo();
  EXPECT_EQ(studio.editor.document().cues[0].followSeconds, std::nullopt);
}

TEST(CueEdit, RemovingALookTakesItsCueAndUndoBringsBothBack) {
  StudioParts studio;
  openLit(studio);
  recordCueLine(studio.lights, "");
  removeLook(studio.lights, 0);
  EXPECT_TRUE(studio.editor.document().cues.empty());
  EXPECT_THAT(studio.said(), HasSubstr("Cue 1 is removed, and its cue with it"));
  studio.editor.undo();
  EXPECT_EQ(studio.editor.document().cues.size(), 1U);
  renameLook(studio.lights, 0, "Night");
  EXPECT_EQ(studio.editor.document().cues[0].look, "Night");
}

TEST(LookEdit, AVersionIsRecalledWithItsEdits) {
  StudioParts studio;
  openLit(studio);
  Edit edit;
  edit.operation = GainOperation{2, 0};
  studio.append(edit);
  keepVersion(studio.lights);
  studio.editor.undo();
  studio.editor.undo();
  studio.editor.redo();
  studio.editor.redo();
  const SavedLook version = studio.editor.document().looks[0];
  ASSERT_TRUE(version.scene);
  Document without = studio.editor.document();
  without.edits.edits.clear();
  studio.editor.edit("Remove the edit", without);
  dim(studio, -3);
  recallLook(studio.lights, version);
  EXPECT_EQ(studio.editor.document().edits.edits.size(), 1U);
  EXPECT_EQ(studio.editor.document().rig.lights[0].stops, 0);
  dim(studio, -1);
  replaceLook(studio.lights, 0);
  EXPECT_EQ(studio.editor.document().looks[0].rig.lights[0].stops, -1);
  EXPECT_TRUE(studio.editor.document().looks[0].scene);
}

}  // namespace
}  // namespace swaplight
