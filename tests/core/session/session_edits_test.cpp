#include <gtest/gtest.h>

#include <array>
#include <random>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/apply/edited_set.h"
#include "core/file/json_file.h"
#include "core/session/document_editor.h"
#include "core/session/session_file.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

constexpr int kSide = 600;

Stroke strokeAcross(float y) {
  Stroke stroke;
  stroke.radius = 20;
  stroke.points = {{100, y, 1}, {200, y + 5, 1}};
  return stroke;
}

Edit paintedEdit(const Painting& painting) {
  Edit edit;
  edit.name = "Paint";
  edit.lights = {"key"};
  edit.energy = EnergyMode::Add;
  edit.operation = GainOperation{1, .5F};
  edit.mask = {{PaintShape{std::make_shared<const Painting>(painting)}, false}};
  return edit;
}

Document documentWithStrokes(int count) {
  Document document;
  document.source = "/sets/kitchen/capture.json";
  document.edits.width = document.edits.height = kSide;
  Painting painting(kSide, kSide);
  for (int i = 0; i < count; ++i) painting.begin(strokeAcross(100 + 20.F * static_cast<float>(i)));
  document.edits.append(paintedEdit(painting));
  return document;
}

TEST(SessionEdits, TravelWithTheSessionAndNameFilesFromWhereItLies) {
  const test::TemporaryFolder folder;
  Session session;
  session.document = documentWithStrokes(3);
  session.document.edits.newLights = {"window"};
  Edit stencil;
  stencil.mask = {{ImageShape{(folder.path() / "leaf.png").string(), 1, 2, 30, 40}, false}};
  session.document.edits.append(stencil);
  writeSession(session, folder.path() / "a.swaplight");
  const Session read = readSession(folder.path() / "a.swaplight");
  EXPECT_TRUE(read.document == session.document);
  EXPECT_TRUE(read.warnings.empty());
  const Json json = readJson(folder.path() / "a.swaplight");
  EXPECT_EQ(json["edits"]["edits"][1]["mask"][0]["file"], "leaf.png");
}

TEST(SessionEdits, OlderSessionsHaveNone) {
  const Json json{{"format", "swaplight-session"}, {"version", 1}, {"source", "set.exr"}};
  EXPECT_TRUE(sessionFromJson(json, "/", "old").document.edits == EditStack{});
}

TEST(SessionEdits, StrokesNeedTheSizeOfThePicture) {
  const Json json{{"format", "swaplight-session"}, {"edits", {{"edits", Json::array()}}}};
  EXPECT_THROW(static_cast<void>(sessionFromJson(json, "/", "a")), InputError);
}

TEST(SessionEdits, ASizeThatNoIntHoldsIsNotTakenForAnother) {
  const auto sized = [](const char* width) {
    const Json edits{{"edits", Json::array()}, {"size", {Json::parse(width), 64}}};
    return sessionFromJson(
               {{"format", "swaplight-session"}, {"version", 1}, {"source", "set.exr"}, {"edits", edits}},
               "/", "a")
        .document.edits.width;
  };
  EXPECT_EQ(sized("64"), 64);
  for (const char* width : {"4294967360", "-4294967232", "18446744069414584384", "64.5"})
    EXPECT_THROW(static_cast<void>(sized(width)), InputError) << width;
}

TEST(SessionEdits, AStrokeCostsTheHistoryOnlyTheTilesThatItTouches) {
  const Document before = documentWithStrokes(1);
  Document after = before;
  Painting painting = *std::get<PaintShape>(before.edits.edits[0]->mask[0].shape).painting;
  painting.begin(strokeAcross(120));  // within one tile
  after.edits.replace(0, paintedEdit(painting));
  EXPECT_LT(documentBytes(after, before), size_t{150} << 10);
  EXPECT_LT(documentBytes(before, before), 2 * sizeof(Document));
}

TEST(SessionEdits, AnotherSizeOfThePictureGetsItsStrokesPaintedAgain) {
  const EditStack fitted = fitEdits(documentWithStrokes(2).edits, 300, 200);
  const auto& painting = *std::get<PaintShape>(fitted.edits[0]->mask[0].shape).painting;
  EXPECT_EQ(painting.mask().width(), 300);
  EXPECT_EQ(painting.strokes().size(), 2U);
  EXPECT_GT(painting.mask().at(150, 102), 0);
}

// Random strokes of the four kinds of brush, added to the light or taken away.
TEST(SessionEdits, AStrokeChangesOnlyTheChosenLightAndOnlyWhereItWasPainted) {
  std::mt19937 random(7);
  const auto upTo = [&](float most) { return std::uniform_real_distribution<float>(0, most)(random); };
  const SolvedSet set = test::smallSet(3, 300, 270);
  const std::array<Operation, 4> brushes{GainOperation{1, .4F}, FillOperation{0}, BlurOperation{6},
                                         FillOperation{.7F}};
  for (int i = 0; i < 24; ++i) {
    Painting painting(set.width(), set.height());
    Stroke stroke;
    stroke.radius = 4 + upTo(30);
    stroke.hardness = upTo(1);
    stroke.opacity = upTo(1);
    stroke.points = {{upTo(300), upTo(270), 1}, {upTo(300), upTo(270), 1}};
    painting.begin(stroke);
    const size_t light = static_cast<size_t>(i) % 3;
    Edit edit = paintedEdit(painting);
    edit.lights = {set.capture.lights[light].name};
    edit.operation = brushes[static_cast<size_t>(i) % brushes.size()];
    EditStack stack;
    stack.append(edit);
    const SolvedSet edited = applyEdits(set, stack);
    for (size_t l = 0; l < 3; ++l)
      for (int c = 0; c < 3; ++c)
        for (int y = 0; y < set.height(); ++y)
          for (int x = 0; x < set.width(); ++x) {
            if (l == light && painting.mask().at(x, y) > 0) continue;
            ASSERT_EQ(edited.contributions[l].view().at(c, x, y), set.contributions[l].view().at(c, x, y))
                << "light " << l << " at " << x << ", " << y;
          }
  }
}

}  // namespace
}  // namespace swaplight
