#include "core/edit/mask/selection.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/apply/edited_set.h"
#include "core/edit/mask/drag_shape.h"
#include "core/edit/mask/mask_outline.h"
#include "core/edit/mask/prepared_mask.h"
#include "core/session/session_file.h"
#include "tests/support/small_set.h"

namespace swaplight {
namespace {

constexpr int kWidth = 300, kHeight = 200;

MaskShape box(float x, float y, float width, float height) {
  return {RectangleShape{x, y, width, height, 0}, false};
}

float at(const Mask& mask, const SolvedSet& set, int x, int y) {
  MaskContext context(set);
  float value = 1;
  PreparedMask(mask, context).row(x, y, 1, &value);
  return value;
}

/// Dark on the left, bright on the right, with a bright island on the left; the first light's share is high
/// above, low below.
SolvedSet twoHalves() {
  SolvedSet set = test::smallSet(2, kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool island = x >= 40 && x < 70 && y >= 40 && y < 70;
      const float total = x < kWidth / 2 && !island ? 0.1F : 0.8F;
      const float share = y < kHeight / 2 ? 0.7F : 0.2F;
      for (int i = 0; i < 2; ++i) {
        const float part = i == 0 ? share : 1 - share;
        set.beta.span().at(i, x, y) = part;
        for (int c = 0; c < 3; ++c)
          set.contributions[static_cast<size_t>(i)].span().at(c, x, y) = part * total;
      }
    }
  return set;
}

TEST(Selection, PartsAreAddedTakenAwayAndIntersected) {
  const SolvedSet set = test::smallSet(2, kWidth, kHeight);
  Mask selection = selectionWith({}, box(20, 20, 100, 100), SelectHow::Replace);
  EXPECT_EQ(at(selection, set, 50, 50), 1);
  EXPECT_EQ(at(selection, set, 150, 50), 0);
  selection = selectionWith(selection, box(140, 20, 40, 100), SelectHow::Add);
  EXPECT_EQ(at(selection, set, 150, 50), 1);
  selection = selectionWith(selection, box(40, 40, 20, 20), SelectHow::Subtract);
  EXPECT_EQ(at(selection, set, 50, 50), 0);
  EXPECT_EQ(at(selection, set, 30, 50), 1);
  selection = selectionWith(selection, box(0, 0, 100, 200), SelectHow::Intersect);
  EXPECT_EQ(at(selection, set, 30, 50), 1);
  EXPECT_EQ(at(selection, set, 150, 50), 0);
  const Mask inverted = invertedSelection(selection);
  EXPECT_EQ(at(inverted, set, 30, 50), 0);
  EXPECT_EQ(at(inverted, set, 150, 50), 1);
  const Mask more = selectionWith(inverted, box(25, 45, 10, 10), SelectHow::Add);
  EXPECT_EQ(at(more, set, 30, 50), 1);
  EXPECT_EQ(at(more, set, 22, 50), 0);
  EXPECT_EQ(at(more, set, 250, 150), 1);
}

TEST(Selection, NothingIsLeftOfNothing) {
  EXPECT_TRUE(selectionWith({}, box(0, 0, 9, 9), SelectHow::Subtract).empty());
  EXPECT_TRUE(invertedSelection({}).empty());
  EXPECT_TRUE(selectionOf({{PaintShape{}, false}}).empty());
}

TEST(Selection, ItsEdgeIsAsSoftAsAskedFor) {
  const SolvedSet set = test::smallSet(2, kWidth, kHeight);
  const Mask soft = featheredSelection(selectionWith({}, box(100, 50, 100, 100), SelectHow::Replace), 40);
  EXPECT_NEAR(at(soft, set, 150, 100), 1, 0.01);
  EXPECT_NEAR(at(soft, set, 100, 100), 0.5, 0.05);
  EXPECT_GT(at(soft, set, 92, 100), 0.05);
  EXPECT_LT(at(soft, set, 75, 100), 0.01);
}

TEST(Selection, WhatIsAlikeInColourStopsAtTheEdgeOfTheColour) {
  const SolvedSet set = twoHalves();
  const auto similar = [](int x, bool connected) {
    return selectionWith({}, {SimilarShape{SimilarShape::By::Color, x, 20, 0.1F, connected}, false},
                         SelectHow::Replace);
  };
  EXPECT_EQ(at(similar(200, true), set, 250, 150), 1);
  EXPECT_EQ(at(similar(200, true), set, 100, 150), 0);
  EXPECT_EQ(at(similar(200, true), set, 55, 55), 0) << "the island does not hang together with it";
  EXPECT_EQ(at(similar(200, false), set, 55, 55), 1);
  EXPECT_EQ(at(similar(20, true), set, 100, 150), 1);
}

TEST(Selection, WhatIsAlikeInLightingDoesNotMindTheColour) {
  const SolvedSet set = twoHalves();
  const Mask above = selectionWith({}, {SimilarShape{SimilarShape::By::Share, 20, 20, 0.1F, true}, false},
                                   SelectHow::Replace);
  EXPECT_EQ(at(above, set, 250, 50), 1);
  EXPECT_EQ(at(above, set, 55, 55), 1);
  EXPECT_EQ(at(above, set, 250, 150), 0);
}

TEST(Selection, APlaceOutsideOfThePictureIsSaid) {
  const SolvedSet set = test::smallSet(2, kWidth, kHeight);
  MaskContext context(set);
  EXPECT_THROW((void)context.raster({SimilarShape{SimilarShape::By::Color, 500, 20, 0.1F, true}, false}),
               InputError);
}

TEST(Selection, IsTheSameAfterASessionWasSaved) {
  Document document;
  document.selection = featheredSelection(
      selectionWith(invertedSelection(selectionWith(
                        {}, {PolygonShape{{{1, 1}, {90.5F, 3}, {40, 77}}, 0}, false}, SelectHow::Replace)),
                    {SimilarShape{SimilarShape::By::Share, 7, 8, 0.25F, false}, false}, SelectHow::Subtract),
      12);
  Edit edit;
  edit.operation = FillOperation{1};
  edit.mask = maskWithin({box(1, 2, 3, 4)}, document.selection);
  document.edits.append(edit);
  document.edits.width = kWidth;
  document.edits.height = kHeight;
  Session session;
  session.document = document;
  const Session back = sessionFromJson(jsonFromSession(session, ""), "", "x");
  EXPECT_EQ(back.document.selection, document.selection);
  EXPECT_EQ(back.document.edits, document.edits);
  EXPECT_TRUE(back.warnings.empty());
}

TEST(Selection, AnEditStaysInsideOfIt) {
  const auto set = std::make_shared<const SolvedSet>(test::smallSet(2, kWidth, kHeight));
  Edit edit;
  edit.lights = {set->capture.lights[0].name};
  edit.energy = EnergyMode::Add;
  edit.operation = GainOperation{1, 0.5F};
  edit.mask =
      selectionWith({}, {PolygonShape{{{50, 50}, {150, 60}, {90, 150}}, 0}, false}, SelectHow::Replace);
  EditStack stack;
  stack.append(edit);
  const SolvedSet edited = applyEdits(*set, stack);
  const auto difference = [&](int x, int y) {
    return edited.contributions[0].view().at(0, x, y) - set->contributions[0].view().at(0, x, y);
  };
  EXPECT_GT(difference(95, 80), 0.001F);
  EXPECT_EQ(difference(20, 20), 0);
  EXPECT_EQ(difference(200, 150), 0);
}

TEST(MaskOutline, GoesAroundWhatIsSelected) {
  MaskRaster mask(100, 80);
  const std::vector<float> row(30, 1.0F);
  for (int y = 20; y < 40; ++y) mask.writeRow(10, y, 30, row.data());
  const auto outline = maskOutline(mask);
  ASSERT_EQ(outline.size(), 1U);
  ASSERT_EQ(outline.front().size(), 4U);
  for (const auto& p : outline.front()) {
    EXPECT_TRUE(p[0] == 10.5F || p[0] == 39.5F);
    EXPECT_TRUE(p[1] == 20.5F || p[1] == 39.5F);
  }
}

TEST(DragShape, WordsAreAsWideAsTheDrag) {
  Stencil stencil;
  stencil.text = "LIGHT";
  const MaskShape shape = draggedShape(stencil, {100, 50}, {260, 90}, false);
  const ShapeBox drawn = boxOf(shape).value();
  EXPECT_NEAR(drawn.x1 - drawn.x0, 160, 12);
  EXPECT_NEAR(drawn.y1, 90, 2);
  EXPECT_EQ(boxOf(movedShape(shape, 30, -10)).value().x0, drawn.x0 + 30);
}

TEST(DragShape, EvenDragsMakeCirclesAndStraightGradients) {
  Stencil stencil;
  stencil.shape = "ellipse";
  const auto circle = std::get<EllipseShape>(draggedShape(stencil, {10, 10}, {50, 30}, true).shape);
  EXPECT_EQ(circle.radiusX, circle.radiusY);
  stencil.shape = "linear";
  const auto line = std::get<LinearGradientShape>(draggedShape(stencil, {10, 10}, {110, 14}, true).shape);
  EXPECT_NEAR(line.y1, 10, 1e-3);
  EXPECT_TRUE(isOfKind({line, false}, stencil));
}

TEST(DragShape, EveryKindIsItsOwn) {
  ASSERT_EQ(stencilKinds().size(), 7U);
  for (const StencilKind& kind : stencilKinds()) {
    Stencil stencil;
    stencil.shape = kind.info.name;
    const MaskShape shape = draggedShape(stencil, {10, 10}, {60, 50}, false);
    for (const StencilKind& other : stencilKinds()) {
      Stencil another;
      another.shape = other.info.name;
      EXPECT_EQ(isOfKind(shape, another), another.shape == stencil.shape);
    }
    EXPECT_EQ(withStencil(shape, stencil), shape);
  }
}

TEST(Lasso, KnowsWhetherItEnclosesAnything) {
  const auto breadth = [](const PointList& points) { return PolygonShape{points, 0}.breadth(); };
  EXPECT_EQ(breadth({}), 0);
  EXPECT_EQ(breadth({{3, 4}}), 0);
  EXPECT_EQ(breadth({{1, 1}, {5, 5}, {9, 9}, {1, 1}}), 0) << "there and back";
  EXPECT_FLOAT_EQ(breadth({{0, 0}, {10, 0}, {20, 0}, {10, 4}}), 4);
  EXPECT_FLOAT_EQ(breadth({{0, 0}, {10, -3}, {20, 0}, {10, 4}}), 7) << "both sides";
}

}  // namespace
}  // namespace swaplight
