#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/json.h"
#include "core/edit/apply/edited_set.h"
#include "core/edit/guide/edge_guide.h"
#include "core/edit/shapes/paint.h"

namespace swaplight {
namespace {

constexpr int kWidth = 300, kHeight = 200, kEdge = 150;

/// Two surfaces with an upright edge between them at kEdge, so many stops apart in each channel; both fall
/// off by half a stop from top to bottom and vary by 3 % from pixel to pixel.
std::shared_ptr<const SolvedSet> twoSurfaces(const Rgb& stops) {
  std::mt19937 random(3);
  std::normal_distribution<float> grain(0, 0.03F);
  auto set = std::make_shared<SolvedSet>();
  set->capture.lights.push_back({"key", Role::Key, {}});
  Image light(ImageSpec::rgb(kWidth, kHeight));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        light.span().at(c, x, y) =
            0.3F * std::exp2((x < kEdge ? 0 : stops[c]) - 0.5F * float(y) / kHeight) * (1 + grain(random));
  set->contributions.push_back(std::move(light));
  set->beta = Image(ImageSpec{kWidth, kHeight, {}, "data"});
  updateBeta(*set);
  return set;
}

/// Along the edge, whose other side the brush overlaps by 20 of its 28 pixels.
Stroke strokeBesideTheEdge(bool edges) {
  Stroke stroke;
  stroke.radius = 28;
  stroke.flow = 1;
  stroke.hardness = 0.9F;
  stroke.edges = edges;
  stroke.points = {{kEdge - 8, 40, 1}, {kEdge - 8, 160, 1}};
  return stroke;
}

Painting painted(const std::shared_ptr<const EdgeGuide>& guide, bool edges) {
  Painting painting(kWidth, kHeight, guide);
  painting.begin(strokeBesideTheEdge(edges));
  return painting;
}

/// The mean of the mask in the columns first .. end of the stroke.
double meanOf(const MaskRaster& mask, int first, int end) {
  double sum = 0;
  for (int y = 60; y < 140; ++y)
    for (int x = first; x < end; ++x) sum += double{mask.at(x, y)};
  return sum / (80.0 * (end - first));
}

TEST(EdgeBrush, PaintStaysOnItsSideOfAnEdge) {
  const struct {
    Rgb stops;
    double leak;  ///< of what a plain brush paints over there, at most
    const char* what;
  } edges[] = {{{-1, -1, -1}, 0.001, "one stop darker"},
               {{1, 1, 1}, 0.001, "one stop lighter"},
               {{0.7F, 0, -0.7F}, 0.001, "as light, of another colour"},
               {{-0.7F, -0.7F, -0.7F}, 0.01, "seven tenths of a stop darker"},
               {{-0.5F, -0.5F, -0.5F}, 0.2, "half a stop darker"},
               {{-0.3F, -0.3F, -0.3F}, 1.01, "three tenths of a stop darker: no edge to it"}};
  for (const auto& edge : edges) {
    const auto set = twoSurfaces(edge.stops);
    const auto guide = std::make_shared<const EdgeGuide>(set);
    const Painting plain = painted(guide, false), following = painted(guide, true);
    // Beside the two columns that the average over 3 x 3 pixels mixes.
    const double leak =
        meanOf(following.mask(), kEdge + 1, kEdge + 16) / meanOf(plain.mask(), kEdge + 1, kEdge + 16);
    const double kept =
        meanOf(following.mask(), kEdge - 28, kEdge - 1) / meanOf(plain.mask(), kEdge - 28, kEdge - 1);
    EXPECT_LT(leak, edge.leak) << edge.what;
    EXPECT_GT(kept, 0.97) << edge.what;
    RecordProperty(edge.what, std::to_string(leak) + " over, " + std::to_string(kept) + " kept");
  }
}

TEST(EdgeBrush, WithoutAnEdgeItPaintsAsABrushDoes) {
  const auto guide = std::make_shared<const EdgeGuide>(twoSurfaces(Rgb(0)));
  const Painting plain = painted(guide, false), following = painted(guide, true);
  EXPECT_GT(meanOf(following.mask(), kEdge - 30, kEdge + 14) / meanOf(plain.mask(), kEdge - 30, kEdge + 14),
            0.97);
}

TEST(EdgeBrush, OffItGivesTheSameBits) {
  const auto guide = std::make_shared<const EdgeGuide>(twoSurfaces(Rgb(-1)));
  const Painting with = painted(guide, false), without = painted(nullptr, false);
  EXPECT_TRUE(with.mask().differences(without.mask()).empty());
  EXPECT_FALSE(with.followsEdges());
  EXPECT_FALSE(jsonFromStroke(*with.strokes().front()).contains("edges")) << "files stay as they were";
}

TEST(EdgeBrush, AFileAStrokeInHandAndTheWholePictureGiveTheSameBits) {
  const auto set = twoSurfaces(Rgb(-1));
  const auto guide = std::make_shared<const EdgeGuide>(set);
  const auto stackOf = [](Painting painting) {
    Edit edit;
    edit.lights = {"key"};
    edit.energy = EnergyMode::Add;
    edit.operation = GainOperation{1, 0.5F};
    edit.mask = {{PaintShape{std::make_shared<const Painting>(std::move(painting))}, false}};
    EditStack stack;
    stack.width = kWidth, stack.height = kHeight;
    stack.append(edit);
    return stack;
  };
  // In hand: with its guide, point by point, tile by tile.
  EditedSet live(set);
  Painting stroke(kWidth, kHeight, guide);
  Stroke begun = strokeBesideTheEdge(true);
  const std::vector<StrokePoint> points = std::exchange(begun.points, {});
  stroke.begin(begun);
  for (const StrokePoint& point : points) {
    stroke.add(point);
    live.setStack(stackOf(stroke));
    live.update();
  }
  // From a file: without one.
  Painting read(kWidth, kHeight);
  read.begin(strokeFromJson(jsonFromStroke(*stroke.strokes().front()), "stroke"));
  EXPECT_TRUE(read.followsEdges());
  const SolvedSet whole = applyEdits(*set, stackOf(read));
  EditedSet opened(set);
  opened.setStack(stackOf(read));
  opened.update();
  // And a further stroke on what was read, which has its guide then.
  Painting more = read.guidedBy(guide);
  more.begin(strokeBesideTheEdge(false));
  opened.setStack(stackOf(more));
  opened.update();
  const SolvedSet moreWhole = applyEdits(*set, stackOf(more));
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < whole.beta.pixelCount(); ++p) {
      ASSERT_EQ(live.result().contributions[0].plane(c)[p], whole.contributions[0].plane(c)[p]) << p;
      ASSERT_EQ(opened.result().contributions[0].plane(c)[p], moreWhole.contributions[0].plane(c)[p]) << p;
    }
}

}  // namespace
}  // namespace swaplight
