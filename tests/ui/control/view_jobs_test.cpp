// What is made in threads of what is seen: shadows, scopes, exports.
#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "core/image/io/image_io.h"
#include "core/relight/setting.h"
#include "tests/support/studio_parts.h"
#include "ui/control/shadow_edit.h"

namespace swaplight {
namespace {

using test::StudioParts;
using testing::HasSubstr;

template <typename Condition>
void showShadowsUntil(StudioParts& studio, const char* what, const Condition& holds) {
  studio.until(what, [&] {
    studio.shadows.show();
    return holds();
  });
}

TEST(ShadowController, ShowsAPreviewThenWhatWasFound) {
  StudioParts studio;
  studio.open(test::discSet());
  EXPECT_EQ(studio.shadows.shown(), nullptr);
  showShadowsUntil(studio, "no preview", [&] { return studio.shadows.preview() != nullptr; });
  showShadowsUntil(studio, "no outlines", [&] {
    return studio.edits.shadowsCurrent() && !studio.shadows.busy() && studio.shadows.shown() != nullptr;
  });
  EXPECT_FALSE(studio.shadows.shown()->outlines.umbra.empty()) << "the disc's";
  studio.view.selectedLight = 1;
  showShadowsUntil(studio, "no outlines of the other light",
                   [&] { return !studio.shadows.busy() && studio.shadows.shown() != nullptr; });
}

TEST(ShadowController, KnowsWhereNothingCanBeToldUntilItIsSaid) {
  StudioParts studio;
  SolvedSet set = test::discSet();
  for (Image& contribution : set.contributions)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < 30; ++y) std::fill_n(contribution.span().row(c, y), 40, 0.F);  // black
  updateBeta(set);
  studio.open(std::move(set));
  const auto shown = [&] {
    return studio.edits.shadowsCurrent() && !studio.shadows.busy() && studio.shadows.shown() != nullptr;
  };
  showShadowsUntil(studio, "nothing is shown", shown);
  EXPECT_TRUE(studio.shadows.shown()->untold.at(20, 15));
  EXPECT_FALSE(studio.shadows.shown()->untold.at(150, 110));
  markShadow(studio.editingContext, "key", {ShadowMark::Kind::Shadow, 20, 15}, 1);
  showShadowsUntil(studio, "the preview does not follow",
                   [&] { return studio.shadows.shown() && !studio.shadows.shown()->untold.at(20, 15); });
  showShadowsUntil(studio, "nothing is found", shown);
  EXPECT_FALSE(studio.shadows.shown()->untold.at(20, 15));
}

TEST(ShadowController, AClickChoosesTheShadowUnderItOrAllOfThem) {
  StudioParts studio;
  studio.open(test::discSet());
  studio.shadows.show();
  studio.shadows.choose(80, 60);  // before anything is found: as soon as it is
  showShadowsUntil(studio, "nothing is chosen", [&] { return studio.editing.shadow.chosen.has_value(); });
  EXPECT_EQ(studio.editing.shadow.light, "key");
  studio.shadows.choose(3, 3);
  showShadowsUntil(studio, "it stays chosen", [&] { return !studio.editing.shadow.chosen.has_value(); });
  EXPECT_THAT(studio.said(), HasSubstr("no shadow of key here"));
  studio.shadows.choose(80, 60);
  showShadowsUntil(studio, "nothing is chosen", [&] { return studio.editing.shadow.chosen.has_value(); });
  studio.shadows.chooseAll();
  EXPECT_FALSE(studio.editing.shadow.chosen.has_value());
}

TEST(ShadowController, AnotherSetForgetsWhatWasShown) {
  StudioParts studio;
  studio.open(test::discSet());
  studio.shadows.choose(80, 60);
  showShadowsUntil(studio, "nothing is chosen", [&] { return studio.editing.shadow.chosen.has_value(); });
  studio.open(test::smallSet(2, 64, 48));
  studio.shadows.show();
  EXPECT_EQ(studio.shadows.preview(), nullptr);
  EXPECT_FALSE(studio.editing.shadow.chosen.has_value());
}

TEST(ShadowController, APreviewThatNobodyHasTakenYetIsNotTheNextSets) {
  StudioParts studio;
  studio.open(test::discSet());
  studio.shadows.show();
  std::this_thread::sleep_for(std::chrono::seconds(1));  // it is made meanwhile
  studio.open(test::smallSet(2, 64, 48));
  studio.shadows.show();
  EXPECT_EQ(studio.shadows.preview(), nullptr);
}

TEST(ShadowController, GivesALightsVisibilityToTheViewer) {
  StudioParts studio;
  studio.open(test::discSet());
  EXPECT_EQ(studio.shadows.visibility(0), nullptr);
  studio.until("no visibility", [&] { return studio.shadows.visibility(0) != nullptr; });
  EXPECT_LT(studio.shadows.visibility(0)->level(0).at(0, 80, 60), 0.2F);
  EXPECT_GT(studio.shadows.visibility(0)->level(0).at(0, 5, 5), 0.8F);
  EXPECT_EQ(studio.shadows.visibility(2), nullptr) << "there is no third light";
}

void countedUntil(StudioParts& studio, uint64_t revision) {
  studio.until("nothing is counted", [&] {
    studio.scopes.update();
    return studio.scopes.revision() >= revision;
  });
}

TEST(ScopesController, CountsOnceForEveryLightingThatIsSeen) {
  StudioParts studio;
  EXPECT_EQ(studio.scopes.pictures(), nullptr);
  studio.scopes.update();
  studio.open(test::smallSet(2, 120, 90));
  countedUntil(studio, 1);
  ASSERT_NE(studio.scopes.pictures(), nullptr);
  EXPECT_FALSE(studio.scopes.pictures()->waveform.rgba.empty());
  for (int i = 0; i < 50; ++i) {
    studio.scopes.update();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(studio.scopes.revision(), 1U) << "nothing changed";

  const std::vector<uint8_t> before = studio.scopes.pictures()->waveform.rgba;
  Document next = studio.editor.document();
  for (LightSetting& light : next.rig.lights) light.stops = -3;
  studio.editor.edit("Darker", next);
  countedUntil(studio, 2);
  EXPECT_NE(studio.scopes.pictures()->waveform.rgba, before);
}

TEST(ScopesController, FollowsEditsOfThePixels) {
  StudioParts studio;
  studio.open(test::smallSet(2, 120, 90));
  countedUntil(studio, 1);
  Edit edit;
  edit.lights = {"light1"};
  edit.energy = EnergyMode::Add;
  edit.operation = FillOperation{0};
  studio.append(edit);
  const std::vector<uint8_t> before = studio.scopes.pictures()->waveform.rgba;
  studio.until("the scopes do not follow", [&] {
    studio.scopes.update();
    return studio.scopes.pictures()->waveform.rgba != before && !studio.edits.busy();
  });
}

TEST(ScopesController, ALightAloneIsCountedWithoutTheOthers) {
  StudioParts studio;
  studio.open(test::smallSet(2, 120, 90));
  countedUntil(studio, 1);
  const std::vector<uint8_t> all = studio.scopes.pictures()->waveform.rgba;
  studio.layout.scopeOptions.of = ScopeOptions::Of::Light;
  countedUntil(studio, 2);
  EXPECT_NE(studio.scopes.pictures()->waveform.rgba, all);
}

ExportRequest frameTo(const std::filesystem::path& file) {
  ExportRequest request;
  request.file = file;
  return request;
}

TEST(ExportController, WritesInAThreadAndSaysSo) {
  StudioParts studio;
  studio.open(test::smallSet(2, 64, 48));
  const std::filesystem::path file = studio.folder / "frame.exr";
  studio.exports.start(studio.colors.config(), studio.session.set()->original, studio.editor.document(),
                       frameTo(file));
  EXPECT_TRUE(studio.exports.busy());
  EXPECT_EQ(studio.exports.name(), "frame.exr");
  studio.until("nothing is written", [&] { return !studio.exports.busy(); });
  EXPECT_THAT(studio.said(), HasSubstr("Exported " + file.string()));
  EXPECT_EQ(readImage(file).image.width(), 64);
}

TEST(ExportController, WhatIsExportedIsTheDocumentAsItWasThen) {
  StudioParts studio;
  studio.open(test::smallSet(2, 64, 48));
  const std::filesystem::path lit = studio.folder / "lit.exr", again = studio.folder / "again.exr";
  studio.exports.start(studio.colors.config(), studio.session.set()->original, studio.editor.document(),
                       frameTo(lit));
  Document next = studio.editor.document();
  for (LightSetting& light : next.rig.lights) light.on = false;
  studio.editor.edit("Off", next);
  studio.until("nothing is written", [&] { return !studio.exports.busy(); });
  const Image image = readImage(lit).image;
  EXPECT_GT(*std::max_element(image.plane(1), image.plane(1) + image.pixelCount()), 0.1F);
}

TEST(ExportController, SaysWhatWentWrong) {
  StudioParts studio;
  studio.open(test::smallSet(2, 64, 48));
  test::writeBytes(studio.folder / "file", "in the way");
  studio.exports.start(studio.colors.config(), studio.session.set()->original, studio.editor.document(),
                       frameTo(studio.folder / "file" / "frame.exr"));
  studio.until("it goes on", [&] { return !studio.exports.busy(); });
  EXPECT_EQ(studio.errors(), 1U);
  EXPECT_FALSE(studio.exports.cancelling());
}

}  // namespace
}  // namespace swaplight
