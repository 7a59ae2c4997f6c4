#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/relight/setting.h"
#include "core/session/document_editor.h"
#include "core/session/recent_files.h"
#include "core/session/recovery.h"
#include "core/session/session_file.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

Document documentWithKey(const std::string& setting) {
  Document document;
  document.source = "/sets/kitchen/capture.json";
  document.rig = defaultRig(std::vector<std::string>{"key", "fill"});
  applySetting(document.rig.lights[0], setting);
  return document;
}

TEST(SessionFile, KeepsItsColourConfigurationRelativeToItsFolder) {
  const TemporaryFolder folder;
  Session session;
  session.document = documentWithKey("white");
  session.document.colorConfig = folder / "show/config.ocio";
  writeSession(session, folder / "a.swaplight");
  EXPECT_EQ(readJson(folder / "a.swaplight")["color_config"], "show/config.ocio");
  const Session read = readSession(folder / "a.swaplight");
  EXPECT_EQ(read.document, session.document);
  session.document.colorConfig.clear();
  writeSession(session, folder / "a.swaplight");
  EXPECT_FALSE(readJson(folder / "a.swaplight").contains("color_config"));
}

TEST(History, UndoAndRedoGoThroughEarlierDocuments) {
  History history(documentWithKey("white"));
  history.commit("Key: warm", documentWithKey("3200K"));
  history.commit("Key: brighter", documentWithKey("3200K,+1st"));
  history.undo();
  EXPECT_EQ(history.document(), documentWithKey("3200K"));
  history.undo();
  history.undo();
  EXPECT_EQ(history.document(), documentWithKey("white"));
  EXPECT_FALSE(history.canUndo());
  history.redo();
  history.redo();
  EXPECT_EQ(history.document(), documentWithKey("3200K,+1st"));
  EXPECT_FALSE(history.canRedo());
}

TEST(History, AStepAfterAnUndoForgetsWhatWasUndone) {
  History history(documentWithKey("white"));
  history.commit("a", documentWithKey("3200K"));
  history.undo();
  history.commit("b", documentWithKey("5600K"));
  EXPECT_EQ(history.steps().size(), 2U);
  EXPECT_EQ(history.steps().back().name, "b");
}

TEST(History, ADocumentThatIsThereAlreadyIsNoStep) {
  History history(documentWithKey("white"));
  history.commit("nothing", documentWithKey("white"));
  EXPECT_EQ(history.steps().size(), 1U);
}

TEST(History, TheSavedMarkIsExact) {
  History history(documentWithKey("white"));
  EXPECT_TRUE(history.saved());
  history.commit("a", documentWithKey("3200K"));
  EXPECT_FALSE(history.saved());
  history.markSaved(history.stepId());
  history.commit("b", documentWithKey("5600K"));
  EXPECT_FALSE(history.saved());
  history.undo();
  EXPECT_TRUE(history.saved());
  history.undo();
  history.commit("c", documentWithKey("4300K"));  // the saved step is gone for good
  history.undo();
  EXPECT_FALSE(history.saved());
}

TEST(History, OldStepsGoWhenTheBudgetIsSpent) {
  History history(documentWithKey("white"), "Start", 20000);
  for (int i = 0; i < 1000; ++i) history.commit("step", documentWithKey(fmt::format("{}K", 2000 + i)));
  EXPECT_LE(history.bytes(), 20000U);
  EXPECT_GT(history.steps().size(), 5U);
  EXPECT_EQ(history.document(), documentWithKey("2999K"));
  history.undo();
  EXPECT_EQ(history.document(), documentWithKey("2998K"));
}

TEST(DocumentEditor, AGestureOfManyPreviewsIsOneStep) {
  DocumentEditor editor;
  editor.reset(documentWithKey("white"), "Open");
  for (int i = 1; i <= 50; ++i) editor.preview("key: stops", documentWithKey(fmt::format("+{}st", 0.1 * i)));
  EXPECT_EQ(editor.document(), documentWithKey("+5st"));
  EXPECT_FALSE(editor.saved());
  editor.commit();
  EXPECT_EQ(editor.history().steps().size(), 2U);
  editor.undo();
  EXPECT_EQ(editor.document(), documentWithKey("white"));
  EXPECT_TRUE(editor.saved());
}

TEST(DocumentEditor, AnotherGestureEndsTheOneBefore) {
  DocumentEditor editor;
  editor.reset(documentWithKey("white"), "Open");
  editor.preview("key: stops", documentWithKey("+1st"));
  editor.preview("key: colour", documentWithKey("+1st,3200K"));
  editor.commit();
  EXPECT_EQ(editor.history().steps().size(), 3U);
}

TEST(DocumentEditor, UndoInTheMiddleOfAGestureDropsIt) {
  DocumentEditor editor;
  editor.reset(documentWithKey("white"), "Open");
  editor.edit("key: colour", documentWithKey("3200K"));
  editor.preview("key: stops", documentWithKey("3200K,+2st"));
  editor.undo();
  EXPECT_EQ(editor.document(), documentWithKey("3200K"));
}

TEST(SessionFile, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  Session session;
  session.document = documentWithKey("3200K,green:-0.5,gel:L201,+1.5st,x1.7");
  session.document.rig.lights[1].solo = true;
  session.document.solve.model = Model::Transport;
  session.document.display = {"sRGB", "Raw", "+warm, -bleach"};
  session.document.workingSpace = "acescg";
  session.studio = Json{{"zoom", 2.5}};
  writeSession(session, folder.path() / "a.swaplight");
  const Session read = readSession(folder.path() / "a.swaplight");
  EXPECT_EQ(read.document, session.document);
  EXPECT_EQ(read.studio, session.studio);
  EXPECT_TRUE(read.warnings.empty());
}

FilterPipeline warmLook() {
  FilterPipeline look;
  look.name = "Warm";
  look.stages = {{"exposure", true, {{"stops", -1.0F}}, {}}, {"sepia", false, {}, {}}};
  return look;
}

TEST(SessionFile, KeepsItsCameraLookAndTheFolderOfItsFiles) {
  Session session;
  session.document = documentWithKey("white");
  EXPECT_FALSE(jsonFromSession(session, "/sets").contains("camera_look"));
  session.document.cameraLook = warmLook();
  for (const char* folder : {"", "/sets", "/sets/looks"}) {
    session.document.cameraLook.folder = folder;
    const Json json = jsonFromSession(session, "/sets");
    EXPECT_EQ(json["camera_look"]["filters"][0]["parameters"]["stops"], -1);
    const Session read = sessionFromJson(json, "/sets", "a.swaplight");
    EXPECT_EQ(read.document, session.document) << folder;
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_TRUE(read.unknown.empty());
  }
}

TEST(SessionFile, ACameraLookOfANewerVersionIsSaidAndKept) {
  Session session;
  session.document = documentWithKey("white");
  session.document.cameraLook = warmLook();
  Json json = jsonFromSession(session, "/sets");
  json["camera_look"]["version"] = 2;
  json["camera_look"]["lens"] = "anamorphic";
  const Session read = sessionFromJson(json, "/sets", "a.swaplight");
  EXPECT_TRUE(read.document.cameraLook.stages.empty());
  ASSERT_FALSE(read.warnings.empty());
  EXPECT_THAT(read.warnings[0], HasSubstr("a.swaplight: camera_look"));
  EXPECT_EQ(jsonFromSession(read, "/sets")["camera_look"], json["camera_look"]);
}

TEST(SessionFile, AWorkingSpaceThatNoSetCanHaveIsSaid) {
  Json json = jsonFromSession({}, "/");
  EXPECT_FALSE(json.contains("working_space"));
  json["working_space"] = "srgb";
  EXPECT_THAT(test::inputError([&] { static_cast<void>(sessionFromJson(json, "/", "a.swaplight")); }),
              testing::AllOf(testing::HasSubstr("a.swaplight: working_space"), testing::HasSubstr("acescg")));
}

TEST(SessionFile, NoLookIsNotTheViewsOwn) {
  Session session;
  for (const std::optional<std::string>& look :
       {std::optional<std::string>{}, std::optional<std::string>{""}}) {
    session.document.display.look = look;
    EXPECT_EQ(sessionFromJson(jsonFromSession(session, "/"), "/", "x").document.display.look, look);
  }
}

TEST(SessionFile, PathsAreRelativeToItsFolder) {
  Session session;
  session.document.source = "/sets/kitchen/capture.json";
  EXPECT_EQ(jsonFromSession(session, "/sets/sessions")["source"], "../kitchen/capture.json");
  EXPECT_EQ(jsonFromSession(session, "/sets/kitchen")["source"], "capture.json");
  EXPECT_EQ(sessionFromJson(jsonFromSession(session, "/sets"), "/elsewhere", "x").document.source,
            "/elsewhere/kitchen/capture.json");
}

TEST(SessionFile, ANewerVersionIsSaidAndLosesNothing) {
  Session session;
  session.document = documentWithKey("3200K");
  Json json = jsonFromSession(session, "/sets");
  json["version"] = 7;
  json["hologram"] = {{"depth", 3}};
  json["rig"]["mood"] = "dark";
  json["rig"]["lights"][1]["barn_doors"] = {0.5, 0.25};

  Session read = sessionFromJson(json, "/sets", "newer.swaplight");
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_THAT(read.warnings[0], HasSubstr("version 7"));
  applySetting(read.document.rig.lights[0], "5600K");
  const Json written = jsonFromSession(read, "/sets");
  EXPECT_EQ(written["version"], 7);
  EXPECT_EQ(written["hologram"]["depth"], 3);
  EXPECT_EQ(written["rig"]["mood"], "dark");
  EXPECT_EQ(written["rig"]["lights"][1]["barn_doors"], Json({0.5, 0.25}));
  EXPECT_EQ(sessionFromJson(written, "/sets", "again").document.rig.lights[0].color.kelvin, 5600);
}

TEST(SessionFile, WhatIsNoSessionIsSaid) {
  const TemporaryFolder folder;
  writeJson(Json{{"format", "swaplight-capture"}}, folder.path() / "a.swaplight");
  EXPECT_THROW(readSession(folder.path() / "a.swaplight"), InputError);
  std::ofstream(folder.path() / "b.swaplight") << "{\"format\": \"swaplight-session\",\n \"version\": ";
  EXPECT_THROW(readSession(folder.path() / "b.swaplight"), InputError);
}

TEST(RecentFiles, KeepsTheNewestFirstWithoutRepeats) {
  const TemporaryFolder folder;
  const std::filesystem::path list = folder.path() / "state" / "recent.json";
  RecentFiles recent(list);
  for (const char* name : {"/a", "/b", "/c", "/a"}) recent.add(name);
  EXPECT_THAT(recent.files(), ElementsAre("/a", "/c", "/b"));
  EXPECT_THAT(RecentFiles(list).files(), ElementsAre("/a", "/c", "/b"));
  std::ofstream(list) << "not JSON";
  EXPECT_TRUE(RecentFiles(list).files().empty());
}

// Runs `work` in a process that then kills itself as nothing can catch.
template <typename Work>
void dieAfter(const Work& work) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    work();
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(Recovery, FindsTheSessionOfAProcessThatDied) {
  const TemporaryFolder folder;
  Session session;
  session.document = documentWithKey("3200K,+1st");
  dieAfter([&] {
    auto* slot = new RecoverySlot(folder.path());
    slot->save(session, "/sets/mine.swaplight");
  });
  const std::vector<Recovered> found = findRecovered(folder.path());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].savedAs, "/sets/mine.swaplight");
  EXPECT_TRUE(found[0].opening.empty());
  EXPECT_EQ(readSession(found[0].session).document, session.document);
  discardRecovered(found[0]);
  EXPECT_TRUE(findRecovered(folder.path()).empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Recovery, TellsWhichFileWasBeingOpened) {
  const TemporaryFolder folder;
  dieAfter([&] { (new RecoverySlot(folder.path()))->opening("/sets/heavy.swaplight"); });
  const std::vector<Recovered> found = findRecovered(folder.path());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].opening, "/sets/heavy.swaplight");
  EXPECT_TRUE(found[0].session.empty());
}

TEST(Recovery, ACleanExitAndALivingProcessLeaveNothingToRecover) {
  const TemporaryFolder folder;
  {
    RecoverySlot slot(folder.path());
    slot.save(Session{}, {});
    EXPECT_TRUE(std::filesystem::exists(slot.sessionFile()));
    EXPECT_TRUE(findRecovered(folder.path()).empty());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace swaplight
