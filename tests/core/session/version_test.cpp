#include "core/session/version.h"

#include <gmock/gmock.h>

#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/session/open_source.h"
#include "core/session/session_file.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Edit gainOf(float stops) {
  Edit edit;
  edit.name = "Brighter";
  edit.operation = GainOperation{stops, .5F};
  return edit;
}

Document litDocument() {
  Document document;
  document.source = "/sets/kitchen/capture.json";
  for (const char* name : {"key", "fill"}) {
    LightSetting light;
    light.light = name;
    document.rig.lights.push_back(light);
  }
  document.edits.width = document.edits.height = 64;
  document.edits.append(gainOf(1));
  document.display = {"sRGB", "Standard", {}};
  return document;
}

Document changed(Document document) {
  document.rig.lights[0].stops = -2;
  document.edits.append(gainOf(2));
  document.display.view = "Raw";
  document.cameraLook.name = "mist";
  document.cameraLook.stages.emplace_back();
  document.cameraLook.stages[0].filter = "halation";
  return document;
}

Session recordedSession() {
  Session session;
  session.document = recordCue(litDocument()).document;
  return session;
}

TEST(Version, NoMoreAreRecordedThanASessionCanBeReadWith) {
  Document document = litDocument();
  for (size_t k = document.looks.size(); k < kMostLooks; ++k)
    document = recordCue(std::move(document)).document;
  EXPECT_EQ(document.looks.size(), kMostLooks);
  EXPECT_THROW((void)recordCue(document), InputError);
  EXPECT_EQ(recordCue(document, document.cues.back().number).document.looks.size(), kMostLooks)
      << "made anew";
}

TEST(Version, BringsEverythingBack) {
  const Document before = litDocument();
  const SavedLook version = versionOf(before, "Morning");
  const Document back = recalled(changed(before), version);
  EXPECT_TRUE(back == before);
}

TEST(Version, ItsFilesAreAmongThoseOfTheDocument) {
  const auto pictureEdit = [](const std::string& file) {
    Edit edit;
    edit.operation = BetaMapOperation{file, ""};
    return edit;
  };
  const auto lutIn = [](const std::filesystem::path& folder) {
    FilterPipeline look;
    look.folder = folder;
    look.stages.resize(2);
    look.stages[0].filter = "lut";
    look.stages[0].parameters["table"] = std::string("table.cube");
    look.stages[1].filter = "own.fs";
    return look;
  };
  Document document = litDocument();
  document.source = "/sets/kitchen/solved.exr";
  document.edits.append(pictureEdit("/maps/kept.png"));
  document.cameraLook = lutIn("/kept");
  document.looks.push_back(versionOf(document, "Morning"));
  document.edits = {};
  document.edits.append(pictureEdit("/maps/now.png"));
  document.cameraLook = lutIn("/now");
  ImageShape matte;
  matte.file = "/mattes/hero.png";
  document.selection = {MaskShape{matte}};
  EXPECT_THAT(filesOfDocument(document),
              testing::IsSupersetOf({"/maps/kept.png", "/kept/table.cube", "/kept/own.fs", "/maps/now.png",
                                     "/now/table.cube", "/now/own.fs", "/mattes/hero.png"}));
}

TEST(Version, BringsTheGradeBack) {
  Document before = litDocument();
  before.display.grade = ColorGrade{false, {1.1, 1, .9}, {.01, 0, 0}, {1, 1.2, 1}, .7};
  const SavedLook version = versionOf(before, "Dusk");
  EXPECT_TRUE(recalled(litDocument(), version) == before);
  Session session;
  session.document = before;
  session.document.looks = {version};
  const Session read = sessionFromJson(jsonFromSession(session, {}), {}, "a.swaplight");
  EXPECT_TRUE(read.document.display == before.display);
  ASSERT_EQ(read.document.looks.size(), 1U);
  EXPECT_TRUE(read.document.looks[0].scene->display == before.display);
  EXPECT_TRUE(read.warnings.empty());
}

TEST(Version, AGradeThatIsNoneIsRefused) {
  Session session;
  session.document = litDocument();
  Json json = jsonFromSession(session, {});
  json["display"]["grade"] = {{"slope", {1, 99, 1}}};
  EXPECT_THAT(test::inputError([&] { static_cast<void>(sessionFromJson(json, {}, "a.swaplight")); }),
              HasSubstr("a.swaplight: display: grade: the slope is 99"));
  json["display"]["grade"] = {{"power", 2}};
  EXPECT_THAT(test::inputError([&] { static_cast<void>(sessionFromJson(json, {}, "a.swaplight")); }),
              HasSubstr("three numbers"));
}

TEST(Version, ALookIsALightingOnly) {
  SavedLook look = versionOf(litDocument(), "Morning");
  look.scene.reset();
  const Document now = changed(litDocument()), back = recalled(now, look);
  EXPECT_EQ(back.rig, litDocument().rig);
  EXPECT_TRUE(back.edits == now.edits);
  EXPECT_TRUE(back.display == now.display);
}

TEST(Version, InPartLightsAndEditsGoSoFar) {
  const Document half = recalled(changed(litDocument()), versionOf(litDocument(), "Morning"), .5F);
  EXPECT_NEAR(rigFactors(half.rig)[0].g, (1 + .25) / 2, 1e-5);
  EXPECT_FLOAT_EQ(half.edits.edits[1]->opacity, .5F);
  EXPECT_EQ(half.display.view, "Raw");
}

TEST(RecordCue, KeepsAVersionAndAddsACue) {
  const RecordedCue first = recordCue(litDocument());
  EXPECT_EQ(first.number, 100);
  const RecordedCue second = recordCue(changed(first.document));
  EXPECT_EQ(second.number, 200);
  const Document& show = second.document;
  ASSERT_EQ(show.looks.size(), 2U);
  EXPECT_EQ(show.looks[1].name, "Cue 2");
  EXPECT_EQ(show.cues[1].look, "Cue 2");
  EXPECT_TRUE(show.looks[1].scene->edits == show.edits);
}

TEST(RecordCue, AgainKeepsTimesAndReplacesTheVersion) {
  Document show = recordCue(recordCue(litDocument()).document).document;
  show.cues[0].fadeSeconds = 7;
  show.looks[0].note = "for scene 4";
  const Document again = recordCue(changed(show), 100).document;
  ASSERT_EQ(again.looks.size(), 2U);
  EXPECT_EQ(again.cues[0].fadeSeconds, 7);
  EXPECT_EQ(again.looks[0].note, "for scene 4");
  EXPECT_EQ(again.looks[0].rig.lights[0].stops, -2);
  EXPECT_TRUE(again.looks[1] == show.looks[1]);
}

TEST(RecordCue, DoesNotChangeAVersionThatAnotherCueShows) {
  Document show = recordCue(litDocument()).document;
  show.cues = withCue(show.cues, {200, show.looks[0].name});
  const Document again = recordCue(changed(show), 200).document;
  ASSERT_EQ(again.looks.size(), 2U);
  EXPECT_TRUE(again.looks[0] == show.looks[0]);
  EXPECT_EQ(again.cues[1].look, again.looks[1].name);
}

TEST(Gallery, CuesFollowItsNames) {
  Document show = recordCue(recordCue(litDocument()).document).document;
  show = withLookNamed(std::move(show), 1, "Night");
  EXPECT_EQ(show.cues[1].look, "Night");
  show = withLookRemoved(std::move(show), 0);
  EXPECT_EQ(show.looks.size(), 1U);
  ASSERT_EQ(show.cues.size(), 1U);
  EXPECT_EQ(show.cues[0].look, "Night");
}

TEST(VersionFile, TravelsWithTheSession) {
  const test::TemporaryFolder folder;
  Session session;
  Edit image = gainOf(3);
  image.mask = {{ImageShape{(folder.path() / "leaf.png").string(), 1, 2, 30, 40}, false}};
  session.document = litDocument();
  session.document.edits.append(image);
  session.document = recordCue(changed(recordCue(session.document).document)).document;
  session.document.cues[1].followSeconds = 2.F;
  writeSession(session, folder.path() / "a.swaplight");
  const Session read = readSession(folder.path() / "a.swaplight");
  EXPECT_TRUE(read.document == session.document);
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_TRUE(read.unknown.empty());
  const Json json = readJson(folder.path() / "a.swaplight");
  EXPECT_EQ(json["version"], 1) << "older programs read it";
  EXPECT_EQ(json["looks"][0]["scene"]["edits"]["edits"][1]["mask"][0]["file"], "leaf.png");
  EXPECT_EQ(read.document.looks[1].scene->edits.edits[0], read.document.looks[0].scene->edits.edits[0])
      << "edits of several versions are held once";
}

TEST(VersionFile, IsALookToThoseWhoKnowNoVersions) {
  Json looks = jsonFromSession(recordedSession(), "")["looks"];
  const std::vector<SavedLook> read = savedLooksFromJson(looks, "look");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].rig, litDocument().rig);
  EXPECT_FALSE(read[0].scene);
}

TEST(VersionFile, WhatANewerProgramWroteIsKept) {
  Json json = jsonFromSession(recordedSession(), "");
  json["cues"][0]["curve"] = "slow";
  json["looks"][0]["scene"]["sound"] = "wind";
  const Session read = sessionFromJson(json, "", "a");
  const Json again = jsonFromSession(read, "");
  EXPECT_EQ(again["cues"][0]["curve"], "slow");
  EXPECT_EQ(again["looks"][0]["scene"]["sound"], "wind");
}

TEST(VersionFile, ACueWhoseLookIsGoneIsSaidAndKept) {
  Json json = jsonFromSession(recordedSession(), "");
  json.erase("looks");
  const Session read = sessionFromJson(json, "", "a.swaplight");
  EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("a.swaplight: cue 1: the gallery has no look \"Cue 1\"")));
  EXPECT_EQ(read.document.cues.size(), 1U);
}

}  // namespace
}  // namespace swaplight
