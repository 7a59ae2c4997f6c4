#include "ui/control/session_controller.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "core/relight/setting.h"
#include "core/session/session_file.h"
#include "core/set/solved_file.h"
#include "tests/support/studio_parts.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;
using test::StudioParts;
using testing::HasSubstr;

/// A solved set's file.
fs::path solvedFile(const StudioParts& studio, const std::string& name = "set.exr", int lights = 2) {
  const fs::path file = studio.folder / name;
  SolvedSet set = test::smallSet(lights, 64, 48);
  set.capture.colorSpace = "lin_rec709";
  Shot shot;
  shot.image = "shot_01.exr";
  shot.lightColors.assign(static_cast<size_t>(lights), Rgb(1));
  set.capture.shots.push_back(shot);
  for (Image& contribution : set.contributions) contribution.setColorSpace("lin_rec709");
  set.quality = Image(ImageSpec{64, 48, {"residual", "sigma", "flags", "model"}, "data"}, 0.1F);
  writeSolvedSet(set, file);
  return file;
}

void openAndWait(StudioParts& studio, const fs::path& file) {
  studio.session.open(file);
  studio.until("nothing opens", [&] { return !studio.sets.busy(); });
  ASSERT_NE(studio.session.set(), nullptr) << studio.said();
}

void brighten(StudioParts& studio, float stops) {
  Document next = studio.editor.document();
  next.rig.lights[0].stops = stops;
  studio.editor.edit("Brighter", next);
}

TEST(SessionController, OpensASolvedSetInAThread) {
  StudioParts studio;
  const fs::path file = solvedFile(studio, "kitchen.exr", 3);
  studio.session.open(file);
  EXPECT_TRUE(studio.sets.busy());
  EXPECT_THAT(studio.sets.task(), HasSubstr("kitchen.exr"));
  EXPECT_EQ(studio.session.set(), nullptr) << "it is not there yet";
  EXPECT_FALSE(studio.session.hasDocument());
  studio.until("nothing opens", [&] { return studio.session.set() != nullptr; });
  EXPECT_FALSE(studio.sets.busy());
  EXPECT_GT(studio.woken, 0);
  EXPECT_EQ(studio.editor.document().source, file);
  EXPECT_EQ(studio.editor.document().rig.lights.size(), 3U);
  EXPECT_TRUE(studio.editor.saved());
  EXPECT_EQ(studio.session.set()->solved().lightCount(), 3);
  EXPECT_EQ(studio.session.set()->pictures().width(), 64);
  EXPECT_EQ(studio.session.recent().files().front(), file);
  EXPECT_THAT(studio.session.title(), HasSubstr("kitchen.exr"));
}

TEST(SessionController, NewSetsOpenInTheViewChosenLastAndSessionsInTheirOwn) {
  StudioParts studio;
  const fs::path set = solvedFile(studio);
  openAndWait(studio, set);
  EXPECT_EQ(studio.editor.document().display, (DisplayChoice{"sRGB", "AgX"}));
  EXPECT_TRUE(studio.editor.saved());
  Session plain, log;
  plain.document.source = log.document.source = set;
  log.document.display = {"sRGB", "Log"};
  writeSession(plain, studio.folder / "plain.swaplight");
  writeSession(log, studio.folder / "log.swaplight");
  studio.session.rememberView({"sRGB", "ACES SDR"});
  openAndWait(studio, studio.folder / "plain.swaplight");
  EXPECT_EQ(studio.editor.document().display, DisplayChoice{}) << "as it looked before there was a choice";
  openAndWait(studio, studio.folder / "log.swaplight");
  EXPECT_EQ(studio.editor.document().display, (DisplayChoice{"sRGB", "Log"}));
  openAndWait(studio, set);
  EXPECT_EQ(studio.editor.document().display, (DisplayChoice{"sRGB", "ACES SDR"}));
}

TEST(SessionController, KnowsTheViewThatEachConfigurationOpensIn) {
  StudioParts studio;
  const fs::path handMade = SWAPLIGHT_TEST_DATA "/color/config.ocio";
  EXPECT_EQ(studio.session.openingViewIn({}), (DisplayChoice{"sRGB", "AgX"}));
  EXPECT_EQ(studio.session.openingViewIn(handMade), DisplayChoice{}) << "its own";
  studio.colors.follow(handMade, studio.messages);
  studio.session.rememberView({"Monitor", "Film"});
  EXPECT_EQ(studio.session.openingViewIn(handMade), (DisplayChoice{"Monitor", "Film"}));
  EXPECT_EQ(studio.session.openingViewIn({}), (DisplayChoice{"sRGB", "AgX"})) << "the way back";
}

TEST(SessionController, WhatCannotBeOpenedLeavesWhatIsOpen) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  const auto before = studio.session.set()->original;
  const uint64_t revision = studio.session.setRevision();
  studio.session.open(studio.folder / "nowhere.exr");
  EXPECT_THAT(studio.said(), HasSubstr("nowhere.exr"));
  test::writeBytes(studio.folder / "broken.exr", "this is no picture");
  studio.session.open(studio.folder / "broken.exr");
  studio.until("the broken one goes on", [&] { return !studio.sets.busy(); });
  EXPECT_THAT(studio.said(), HasSubstr("broken.exr"));
  EXPECT_EQ(studio.session.set()->original, before);
  EXPECT_EQ(studio.session.setRevision(), revision);
  EXPECT_EQ(studio.editor.document().source.filename(), "set.exr");
}

TEST(SessionController, ErrorsOfBeforeGoOnceAnotherSetIsOpen) {
  StudioParts studio;
  studio.session.open(studio.folder / "missing.exr");
  EXPECT_EQ(studio.errors(), 1U);
  openAndWait(studio, solvedFile(studio));
  EXPECT_EQ(studio.errors(), 0U) << studio.said();
}

TEST(SessionController, OpeningAnotherOneMeanwhileShowsTheLast) {
  StudioParts studio;
  const fs::path first = solvedFile(studio, "first.exr", 2), second = solvedFile(studio, "second.exr", 4);
  for (int i = 0; i < 5; ++i) studio.session.open(i % 2 == 0 ? first : second);
  studio.session.open(second);
  studio.until("nothing opens", [&] { return !studio.sets.busy(); });
  EXPECT_EQ(studio.editor.document().source, second);
  EXPECT_EQ(studio.session.set()->solved().lightCount(), 4);
  EXPECT_EQ(studio.editor.document().rig.lights.size(), 4U);
}

TEST(SessionController, ClosingWhileItOpensLeavesNothingOpen) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  studio.session.close();
  EXPECT_EQ(studio.session.set(), nullptr);
  EXPECT_FALSE(studio.session.hasDocument());
  EXPECT_EQ(studio.session.title(), "Swaplight");
}

TEST(SessionController, SavesInAThreadAndCallsBackOnceItIsInTheFile) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  brighten(studio, 1);
  EXPECT_FALSE(studio.editor.saved());
  int called = 0;
  const fs::path file = studio.folder / "work.swaplight";
  studio.session.saveAs(file, [&] {
    EXPECT_TRUE(fs::exists(file));
    ++called;
  });
  EXPECT_TRUE(studio.session.saving());
  EXPECT_EQ(called, 0);
  studio.until("it is not saved", [&] { return !studio.session.saving(); });
  EXPECT_EQ(called, 1);
  EXPECT_TRUE(studio.editor.saved());
  EXPECT_EQ(studio.session.file(), file);
  EXPECT_EQ(readSession(file).document, studio.editor.document());
  EXPECT_THAT(studio.said(), HasSubstr("Saved work.swaplight"));

  StudioParts other;
  openAndWait(other, file);
  EXPECT_EQ(other.editor.document().rig.lights[0].stops, 1);
  EXPECT_EQ(other.session.file(), file);
}

TEST(SessionController, WhatChangesWhileItIsSavedIsUnsaved) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  brighten(studio, 1);
  studio.session.saveAs(studio.folder / "work.swaplight");
  brighten(studio, 2);
  studio.until("it is not saved", [&] { return !studio.session.saving(); });
  EXPECT_FALSE(studio.editor.saved());
  EXPECT_EQ(readSession(studio.folder / "work.swaplight").document.rig.lights[0].stops, 1);
}

TEST(SessionController, ASecondSaveWaitsForTheFirst) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  std::string order;
  brighten(studio, 1);
  studio.session.saveAs(studio.folder / "a.swaplight", [&] { order += "a"; });
  brighten(studio, 2);
  studio.session.saveAs(studio.folder / "b.swaplight", [&] { order += "b"; });
  studio.session.afterSaving([&] { order += "!"; });
  studio.until("they are not saved", [&] { return !studio.session.saving(); });
  EXPECT_EQ(order, "ab!");
  EXPECT_EQ(readSession(studio.folder / "a.swaplight").document.rig.lights[0].stops, 1);
  EXPECT_EQ(readSession(studio.folder / "b.swaplight").document.rig.lights[0].stops, 2);
  EXPECT_EQ(studio.session.file().filename(), "b.swaplight");
  EXPECT_TRUE(studio.editor.saved());
}

TEST(SessionController, ASaveThatFailsSaysWhyAndCallsNobody) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  brighten(studio, 1);
  test::writeBytes(studio.folder / "file", "in the way");
  bool called = false;
  studio.session.saveAs(studio.folder / "file" / "work.swaplight", [&] { called = true; });
  studio.until("it goes on", [&] { return !studio.session.saving(); });
  EXPECT_FALSE(called);
  EXPECT_FALSE(studio.editor.saved());
  EXPECT_TRUE(studio.session.file().empty());
  EXPECT_EQ(studio.errors(), 1U);
}

TEST(SessionController, AnotherWorkingSpaceIsMadeInAThreadAndKeepsWhatWasFound) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  const auto found = studio.session.set()->found;
  Document next = studio.editor.document();
  next.workingSpace = "acescg";
  studio.editor.edit("Work in ACEScg", next);
  studio.until("no other space", [&] { return studio.session.set()->original->colorSpace() == "acescg"; });
  EXPECT_EQ(studio.session.set()->found, found);
  EXPECT_NE(studio.session.set()->original, found);
  studio.editor.undo();
  studio.until("not back", [&] { return studio.session.set()->original == found; });
}

/// Sessions that wait for recovery, without those that are being written.
ptrdiff_t sessionsKept(const StudioParts& studio) {
  return std::count_if(
      fs::directory_iterator(studio.folder / "state" / "recovery"), {}, [](const auto& entry) {
        return entry.path().extension() == ".swaplight" && !entry.path().filename().string().starts_with('.');
      });
}

/// What a studio that died would leave: copies, because this one lives and its own are locked.
fs::path remainsOf(const StudioParts& studio) {
  const fs::path state = studio.folder / "died";
  fs::create_directories(state / "recovery");
  for (const fs::directory_entry& entry : fs::directory_iterator(studio.folder / "state" / "recovery"))
    fs::copy_file(entry.path(), state / "recovery" / entry.path().filename());
  return state;
}

TEST(SessionController, UnsavedWorkIsRecoveredAfterTheStudioDied) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  brighten(studio, 3);
  studio.until("nothing is kept for recovery", [&] { return sessionsKept(studio) == 1; });

  StudioParts next(remainsOf(studio));
  ASSERT_EQ(next.session.recovered().size(), 1U);
  const Recovered recovered = next.session.recovered().front();
  next.session.recover();
  EXPECT_FALSE(next.editor.saved()) << "a studio that ends before the pictures are there would lose it";
  next.until("nothing opens", [&] { return next.session.set() != nullptr; });
  EXPECT_EQ(next.editor.document().rig.lights[0].stops, 3);
  EXPECT_FALSE(next.editor.saved()) << "it is in no file of the person's";
  EXPECT_TRUE(next.session.file().empty());
  EXPECT_TRUE(next.session.recovered().empty());
  EXPECT_FALSE(fs::exists(recovered.session)) << "our own place in the folder holds the work";
}

TEST(SessionController, WorkThatCannotBeCopiedIsRecoveredAllTheSameAndStays) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  brighten(studio, 3);
  studio.until("nothing is kept for recovery", [&] { return sessionsKept(studio) == 1; });

  StudioParts next(remainsOf(studio));
  const Recovered recovered = next.session.recovered().front();
  // As on a full disk: nothing can be written where ours would stand.
  for (const fs::directory_entry& entry : fs::directory_iterator(recovered.session.parent_path()))
    if (entry.path().extension() == ".lock" && entry.path() != recovered.lock)
      fs::create_directories(fs::path(entry.path()).replace_extension(".swaplight") / "in the way");
  next.session.recover();
  next.until("nothing opens", [&] { return next.session.set() != nullptr; });
  EXPECT_EQ(next.editor.document().rig.lights[0].stops, 3) << next.said();
  EXPECT_FALSE(next.editor.saved());
  EXPECT_TRUE(fs::exists(recovered.session)) << "the only copy";
}

TEST(SessionController, RecoveredWorkWhosePicturesAreGoneStays) {
  StudioParts studio;
  const fs::path set = solvedFile(studio);
  openAndWait(studio, set);
  brighten(studio, 3);
  studio.until("nothing is kept for recovery", [&] { return sessionsKept(studio) == 1; });

  StudioParts next(remainsOf(studio));
  fs::remove(set);
  next.session.recover();
  next.until("it goes on", [&] { return !next.sets.busy(); });
  EXPECT_EQ(next.session.set(), nullptr);
  EXPECT_EQ(next.editor.document().rig.lights[0].stops, 3);
  EXPECT_FALSE(next.editor.saved());
}

/// A second set is being opened, and the first one's light is changed before it is there.
void changeWhileAnotherOpens(StudioParts& studio) {
  openAndWait(studio, solvedFile(studio, "first.exr"));
  studio.session.open(solvedFile(studio, "second.exr", 4));
  brighten(studio, 2);
  studio.until("it never arrives", [&] { return studio.session.setWaits(); });
  EXPECT_EQ(studio.editor.document().source.filename(), "first.exr");
  EXPECT_EQ(studio.editor.document().rig.lights[0].stops, 2) << "nobody has said that it may go";
}

TEST(SessionController, WhatChangesWhileAnotherOneOpensIsAskedAboutAndMayStay) {
  StudioParts studio;
  changeWhileAnotherOpens(studio);
  studio.session.leaveWaiting();
  studio.session.update();
  EXPECT_FALSE(studio.session.setWaits());
  EXPECT_EQ(studio.session.set()->solved().lightCount(), 2);
  EXPECT_EQ(studio.editor.document().rig.lights[0].stops, 2);
}

TEST(SessionController, WhatChangesWhileAnotherOneOpensMayGo) {
  StudioParts studio;
  changeWhileAnotherOpens(studio);
  studio.session.openWaiting();
  EXPECT_FALSE(studio.session.setWaits());
  EXPECT_EQ(studio.session.set()->solved().lightCount(), 4);
  EXPECT_EQ(studio.editor.document().source.filename(), "second.exr");
  EXPECT_TRUE(studio.editor.saved());
}

TEST(SessionController, AFailedAutosaveIsTriedAgain) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  const fs::path folder = studio.folder / "state" / "recovery";
  fs::path session;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".lock") session = fs::path(entry.path()).replace_extension(".swaplight");
  fs::create_directories(session / "in the way");
  brighten(studio, 3);
  studio.until("nothing is said", [&] { return !studio.said().empty(); });
  fs::remove_all(session);
  studio.until("it is not tried again", [&] { return fs::is_regular_file(session); });
}

TEST(SessionController, NothingIsLeftForRecoveryOnceItIsSaved) {
  StudioParts studio;
  openAndWait(studio, solvedFile(studio));
  brighten(studio, 3);
  studio.until("nothing is kept", [&] { return sessionsKept(studio) == 1; });
  studio.session.saveAs(studio.folder / "work.swaplight");
  studio.until("it stays in recovery", [&] { return !studio.session.saving() && sessionsKept(studio) == 0; });
}

TEST(SetController, GivesItsSetOnceAndSaysWhatItDoes) {
  StudioParts studio;
  Messages messages;
  SetController sets([] {});
  int got = 0;
  const auto take = [&] { return sets.take(messages, [&](const OpenSet&) { ++got; }); };
  EXPECT_EQ(take(), Taken::Nothing);
  sets.load(studio.colors.config(), solvedFile(studio), {}, "acescg");
  Taken taken = Taken::Nothing;
  while ((taken = take()) == Taken::Nothing) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(taken, Taken::Value);
  EXPECT_EQ(take(), Taken::Nothing);
  EXPECT_EQ(got, 1);
}

TEST(SetController, ACancelledLoadGivesNothing) {
  const ColorChoice colors;
  Messages messages;
  SetController sets([] {});
  // A sample has to be solved: long enough to be stopped in its middle.
  sets.load(colors.config(), fs::path(SWAPLIGHT_SAMPLES) / "film_set" / "capture.json", {}, "");
  sets.cancel();
  EXPECT_TRUE(sets.cancelling());
  Taken taken = Taken::Nothing;
  while ((taken = sets.take(messages, [](const OpenSet&) {})) == Taken::Nothing)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(taken, Taken::Stopped);
  EXPECT_TRUE(messages.messages().empty());
  EXPECT_FALSE(sets.cancelling());
}

}  // namespace
}  // namespace swaplight
