// Which colour configuration the studio works with, and what the jobs that run meanwhile work with.
#include "ui/state/color_choice.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/image/io/image_io.h"
#include "tests/support/studio_parts.h"
#include "ui/state/view_memory.h"

namespace swaplight {
namespace {

using test::StudioParts;
using testing::HasSubstr;

/// A foreign configuration; its first display is not the built-in's.
constexpr const char* kHandMade = SWAPLIGHT_TEST_DATA "/color/config.ocio";

TEST(ColorChoice, FollowsASessionAndComesBack) {
  Messages messages;
  ColorChoice colors;
  const auto builtin = colors.config();
  EXPECT_EQ(builtin->name(), "built-in");
  colors.follow(kHandMade, messages);
  const auto handMade = colors.config();
  EXPECT_EQ(handMade->title(), "hand-made");
  colors.follow({}, messages);
  EXPECT_EQ(colors.config(), builtin);
  colors.follow(kHandMade, messages);
  EXPECT_EQ(colors.config(), handMade) << "it is read once";
  EXPECT_TRUE(messages.messages().empty());
}

TEST(ColorChoice, LookingForAnotherOneLeavesTheOneInUse) {
  ColorChoice colors;
  const auto builtin = colors.config();
  EXPECT_EQ(colors.configFor(kHandMade)->title(), "hand-made");
  EXPECT_EQ(colors.configFor("/nowhere/none.ocio"), builtin);
  EXPECT_EQ(colors.config(), builtin);
  EXPECT_TRUE(colors.trouble().empty());
}

TEST(ColorChoice, OneThatCannotBeUsedGivesWayToTheBuiltInAndIsSaidOnce) {
  StudioParts studio;
  ColorChoice colors;
  for (int i = 0; i < 3; ++i) colors.follow("/nowhere/none.ocio", studio.messages);
  EXPECT_EQ(colors.config()->name(), "built-in");
  EXPECT_THAT(colors.trouble(), HasSubstr("/nowhere/none.ocio"));
  EXPECT_EQ(studio.errors(), 1U) << studio.said();
  colors.follow({}, studio.messages);
  EXPECT_TRUE(colors.trouble().empty());
}

TEST(OpeningView, IsRolledOffUntilAnotherOneIsChosen) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = viewMemoryFile(folder / "state");
  const ColorConfig builtin("");
  EXPECT_EQ(openingView(builtin, file), (DisplayChoice{"sRGB", "AgX"}));
  ColorGrade grade;
  grade.saturation = .5;
  rememberView(builtin, {"P3-D65", "ACES SDR", "Blue light fix", grade}, file);
  EXPECT_EQ(openingView(builtin, file), (DisplayChoice{"P3-D65", "ACES SDR", "Blue light fix"}))
      << "a grade is its session's";
  rememberView(builtin, {"P3-D65", "ACES SDR"}, {});
  EXPECT_EQ(openingView(builtin, {}), (DisplayChoice{"sRGB", "AgX"})) << "without a file nothing is kept";
}

TEST(OpeningView, IsEachConfigurationsOwn) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = viewMemoryFile(folder / "state");
  const ColorConfig builtin(""), handMade(kHandMade);
  EXPECT_EQ(openingView(handMade, file), DisplayChoice{}) << "whoever made it has chosen";
  rememberView(handMade, {"Monitor", "Film"}, file);
  EXPECT_EQ(openingView(handMade, file), (DisplayChoice{"Monitor", "Film"}));
  EXPECT_EQ(openingView(builtin, file), (DisplayChoice{"sRGB", "AgX"}));
}

TEST(OpeningView, WhatCannotBeUsedIsForgotten) {
  const test::TemporaryFolder folder;
  const ColorConfig builtin("");
  for (const char* text : {"no JSON", "[1, 2]", R"({"built-in": 3})", R"({"built-in": {"view": 3}})",
                           R"({"built-in": {"display": "Wall", "view": "AgX"}})"}) {
    test::writeBytes(folder / "view.json", text);
    EXPECT_EQ(openingView(builtin, folder / "view.json"), (DisplayChoice{"sRGB", "AgX"})) << text;
  }
}

TEST(ExportController, WritesInTheConfigurationThatWasInUseWhenItBegan) {
  StudioParts studio;
  studio.open(test::smallSet(2, 400, 300));
  const auto write = [&](const char* name) {
    ExportRequest request;
    request.file = studio.folder / name;
    request.frame.display = {"sRGB", "ACES SDR"};  // the other configuration has no such view
    studio.exports.start(studio.colors.config(), studio.session.set()->original, studio.editor.document(),
                         request);
    return request.file;
  };
  const auto written = [&] { studio.until("it is not exported", [&] { return !studio.exports.busy(); }); };
  const auto alone = write("alone.png");
  written();
  const auto meanwhile = write("meanwhile.png");
  studio.colors.follow(kHandMade, studio.messages);
  written();
  EXPECT_EQ(studio.errors(), 0U) << studio.said();
  const Image a = readImage(alone).image, b = readImage(meanwhile).image;
  for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::equal(a.plane(c), a.plane(c) + a.pixelCount(), b.plane(c)));
}

}  // namespace
}  // namespace swaplight
