#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/mask/drag_shape.h"
#include "core/edit/mask/shape_handles.h"

namespace swaplight {
namespace {

using What = ShapeHandle::What;

Point handleAt(const MaskShape& shape, What what) {
  for (const ShapeHandle& handle : handlesOf(shape))
    if (handle.what == what) return handle.at;
  ADD_FAILURE() << "no handle " << handleName(what);
  return {};
}

std::vector<MaskShape> placedShapes() {
  std::vector<MaskShape> shapes;
  for (const char* shape : {"text", "ellipse", "rectangle", "picture", "linear", "radial"}) {
    Stencil of;
    of.shape = shape;
    of.file = "gobo.png";
    shapes.push_back(draggedShape(of, {100, 120}, {300, 260}, false));
    shapes.back().invert = true;
  }
  return shapes;
}

TEST(ShapeHandles, EveryPlacedShapeFollowsEachOfThemAndTheMiddleKeepsItsForm) {
  for (const MaskShape& shape : placedShapes()) {
    const std::vector<ShapeHandle> handles = handlesOf(shape);
    EXPECT_GE(handles.size(), 3U);
    for (const ShapeHandle& handle : handles) {
      SCOPED_TRACE(handleName(handle.what));
      EXPECT_EQ(withHandleAt(shape, handle.what, handle.at, false).shape.index(), shape.shape.index());
      const MaskShape moved = withHandleAt(shape, handle.what, {handle.at[0] + 8, handle.at[1] + 4}, false);
      EXPECT_NE(moved, shape);
      EXPECT_TRUE(moved.invert);
    }
    const Point middle = handleAt(shape, What::Middle);
    EXPECT_EQ(withHandleAt(shape, What::Middle, {middle[0] + 31, middle[1] - 7}, false),
              movedShape(shape, 31, -7));
  }
}

TEST(ShapeHandles, TheCornerOppositeOfTheOneThatIsDraggedStays) {
  const What corners[] = {What::TopLeft, What::TopRight, What::BottomLeft, What::BottomRight};
  const What opposite[] = {What::BottomRight, What::BottomLeft, What::TopRight, What::TopLeft};
  for (const MaskShape& shape : placedShapes()) {
    if (handlesOf(shape).size() < 5) continue;
    for (size_t i = 0; i < 4; ++i) {
      const Point from = handleAt(shape, corners[i]), fixed = handleAt(shape, opposite[i]);
      const MaskShape next = withHandleAt(shape, corners[i], {from[0] + 17, from[1] + 9}, false);
      const Point now = handleAt(next, opposite[i]);
      EXPECT_NEAR(now[0], fixed[0], 1e-3F);
      EXPECT_NEAR(now[1], fixed[1], 1e-3F);
      if (std::holds_alternative<TextShape>(shape.shape)) continue;  // keeps its proportions
      EXPECT_NEAR(handleAt(next, corners[i])[0], from[0] + 17, 1e-3F);
      EXPECT_NEAR(handleAt(next, corners[i])[1], from[1] + 9, 1e-3F);
    }
  }
}

TEST(ShapeHandles, ABoxDoesNotTurnOverAndKeepsItsProportionsWhereAsked) {
  const MaskShape shape{RectangleShape{100, 50, 80, 40, 3}, false};
  const auto least = std::get<RectangleShape>(withHandleAt(shape, What::BottomRight, {20, 10}, false).shape);
  EXPECT_EQ(least, (RectangleShape{100, 50, 2, 2, 3}));
  const auto even = std::get<RectangleShape>(withHandleAt(shape, What::TopLeft, {20, 10}, true).shape);
  EXPECT_NEAR(even.width, 160, 1e-3F);
  EXPECT_NEAR(even.height, 80, 1e-3F);
  EXPECT_NEAR(even.x + even.width, 180, 1e-3F);
}

TEST(ShapeHandles, WordsGrowInProportion) {
  const MaskShape shape{TextShape{"LIGHT", 100, 200, 40, 2}, false};
  const Point from = handleAt(shape, What::BottomRight), fixed = handleAt(shape, What::TopLeft);
  const Point to{fixed[0] + 2 * (from[0] - fixed[0]), fixed[1] + 2 * (from[1] - fixed[1])};
  const auto next = std::get<TextShape>(withHandleAt(shape, What::BottomRight, to, false).shape);
  EXPECT_NEAR(next.height, 80, 0.01F);
  EXPECT_EQ(next.x, 100);
}

TEST(ShapeHandles, EndsOfAGradientSnapToEighthsOfATurn) {
  const MaskShape shape{LinearGradientShape{10, 10, 110, 10}, false};
  const auto even = std::get<LinearGradientShape>(withHandleAt(shape, What::To, {100, 95}, true).shape);
  EXPECT_NEAR(even.x1 - even.x0, even.y1 - even.y0, 1e-3F);
  EXPECT_EQ(even.x0, 10);
  const auto free = std::get<LinearGradientShape>(withHandleAt(shape, What::From, {3, 4}, false).shape);
  EXPECT_EQ(free, (LinearGradientShape{3, 4, 110, 10}));
}

TEST(ShapeHandles, TheInnerRadiusStaysWithinTheOuter) {
  const MaskShape shape{RadialGradientShape{50, 50, 10, 40}, false};
  const auto wide = std::get<RadialGradientShape>(withHandleAt(shape, What::Inner, {150, 50}, false).shape);
  EXPECT_EQ(wide.inner, 40);
  const auto small = std::get<RadialGradientShape>(withHandleAt(shape, What::Outer, {50, 55}, false).shape);
  EXPECT_EQ(small.outer, 5);
  EXPECT_EQ(small.inner, 5);
}

TEST(ShapeHandles, WhatHasNoPlaceHasNone) {
  EXPECT_TRUE(handlesOf({PatternShape{}, false}).empty());
  EXPECT_TRUE(handlesOf({ImageShape{"a.png", 0, 0, 0, 0}, false}).empty());
  EXPECT_TRUE(handlesOf({ShadowShape{"key", false, 0, 0}, false}).empty());
  const MaskShape pattern{PatternShape{}, false};
  EXPECT_EQ(withHandleAt(pattern, What::Middle, {5, 5}, false), pattern);
}

}  // namespace
}  // namespace swaplight
