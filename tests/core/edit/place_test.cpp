#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/edit/apply/edited_set.h"
#include "core/edit/placing/placed_lamp.h"
#include "tests/support/placed_ball.h"

namespace swaplight {
namespace {

using test::ballPaint;
using test::ballShade;
using test::kBallHeight;
using test::kBallWidth;
using test::LitBall;
using testing::HasSubstr;

const std::vector<LampPlace> kFive = test::metered(
    {{-60, 25, {}, {}}, {50, 15, {}, {}}, {0, 60, {}, {}}, {-20, -10, {}, {}}, {30, 45, {}, {}}},
    {0, 1, -1, 0, 0});
const std::vector<double> kLevels = {1, 2, .5, 1, 1};

constexpr double kRim = .85;  // of normals towards the camera

LampPlaces placesOf(const LitBall& ball) {
  LampPlaces places;
  for (const PlacedLight& lamp : ball.lamps) places[ball.set.capture.lights[lamp.light].name] = lamp.place;
  return places;
}

EditStack placed(const PlaceOperation& operation, const std::string& light, const LampPlaces& places) {
  Edit edit;
  edit.name = "test";
  edit.lights = {light};
  edit.energy = EnergyMode::Add;
  edit.operation = operation;
  EditStack stack;
  stack.append(edit);
  stack.lampPlaces = places;
  return stack;
}

SolvedSet edited(const LitBall& ball, const EditStack& stack) {
  const std::shared_ptr<const SolvedSet> set(std::shared_ptr<void>(), &ball.set);
  return applyEdits(ball.set, stack, ball.source(), surfaceSource(set, ball.source(), stack.lampPlaces));
}

/// Of a light against the ball under a lamp of a level: the root of the mean square over that of the truth.
/// Without the ball's rim, which three lamps do not light: there it is a guess.
double relativeError(const Image& light, const LampPlace& place, double level) {
  double squares = 0;
  double all = 0;
  for (int y = 0; y < kBallHeight; ++y)
    for (int x = 0; x < kBallWidth; ++x) {
      if (test::ballNormal(x, y)[2] < kRim) continue;
      const double truth = level * ballPaint(x, y) * ballShade(place, x, y);
      squares += std::pow(light.view().at(1, x, y) - truth, 2);
      all += truth * truth;
    }
  return std::sqrt(squares / all);
}

TEST(Place, ANeutralPlaceGivesTheSameBits) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  const SolvedSet same = edited(ball, placed(PlaceOperation::at(kFive[1]), "lamp1", placesOf(ball)));
  for (size_t i = 0; i < same.contributions.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const Image& was = ball.set.contributions[i];
      EXPECT_TRUE(std::equal(was.plane(c), was.plane(c) + was.pixelCount(), same.contributions[i].plane(c)));
    }
}

TEST(Place, ALampElsewhereLightsTheBallAsItWouldHave) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  const LampPlace there{20, 40, {}, {}};
  const SolvedSet set = edited(ball, placed(PlaceOperation::at(there), "lamp1", placesOf(ball)));
  EXPECT_GT(relativeError(ball.set.contributions[1], there, kLevels[1]), .15);  // as it was
  EXPECT_LT(relativeError(set.contributions[1], there, kLevels[1]), .01);
  EXPECT_LT(relativeError(set.contributions[0], kFive[0], kLevels[0]), 1e-6);
}

TEST(Place, ANewLightIsShadedWithTheStrongestLampsLevel) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  const PlaceOperation operation{-10, 30, 0, 0};
  EditStack stack = placed(operation, "new", placesOf(ball));
  stack.newLights = {"new"};
  const SolvedSet set = edited(ball, stack);
  EXPECT_LT(relativeError(set.contributions[5], operation.place(), 2), .01);
}

Edit edit(const Operation& operation, const std::string& light) {
  Edit made;
  if (!light.empty()) made.lights = {light};
  made.energy = EnergyMode::Add;
  made.operation = operation;
  return made;
}

TEST(Place, AfterARecolouringLightsTheNewColour) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  RecolorOperation red;
  red.kind = RecolorOperation::Kind::Color;
  red.from = Rgb(1);
  red.to = Rgb(1, .1F, .1F);
  for (const char* light : {"lamp1", "new"}) {
    const Edit place = edit(PlaceOperation{20, 40, 0, 0}, light);
    EditStack before, after;
    before.lampPlaces = after.lampPlaces = placesOf(ball);
    before.newLights = after.newLights = {"new"};
    before.append(edit(red, ""));
    before.append(place);
    after.append(place);
    after.append(edit(red, ""));
    const size_t number = light == std::string("new") ? 5 : 1;
    const Image first = edited(ball, before).contributions[number].clone();
    const Image last = edited(ball, after).contributions[number].clone();
    const int x = kBallWidth / 2, y = kBallHeight / 2;
    EXPECT_LT(first.view().at(1, x, y), .3F * first.view().at(0, x, y)) << light;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(first.view().at(c, x, y), last.view().at(c, x, y), .02F * last.view().at(0, x, y)) << light;
  }
}

TEST(Place, BringsBackNoLightThatAnEditTookAway) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  for (const float left : {0.F, .25F}) {
    EditStack stack;
    stack.lampPlaces = placesOf(ball);
    GainOperation dimmed;
    dimmed.gain = left;
    stack.append(edit(dimmed, "lamp1"));
    stack.append(edit(PlaceOperation{20, 40, 0, 0}, "lamp1"));
    const SolvedSet set = edited(ball, stack);
    const int x = kBallWidth / 2, y = kBallHeight / 2;
    const SolvedSet all = edited(ball, placed(PlaceOperation{20, 40, 0, 0}, "lamp1", placesOf(ball)));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(set.contributions[1].view().at(c, x, y), left * all.contributions[1].view().at(c, x, y),
                  1e-4);
  }
}

TEST(Place, OfALightTwiceIsToldFor) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  EditStack stack = placed(PlaceOperation{20, 40, 0, 0}, "lamp1", placesOf(ball));
  const auto isTold = testing::Contains(HasSubstr("\"lamp1\" is placed by an earlier edit"));
  EXPECT_THAT(edited(ball, stack).capture.warnings, testing::Not(isTold));
  stack.append(edit(PlaceOperation{60, 40, 0, 0}, "lamp1"));
  EXPECT_THAT(edited(ball, stack).capture.warnings, isTold);
}

TEST(Place, ANewLampThatIsNearFallsOff) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  const PlaceOperation operation{-30, 10, 1, 0};
  EditStack stack = placed(operation, "new", placesOf(ball));
  stack.newLights = {"new"};
  const SolvedSet set = edited(ball, stack);
  EXPECT_LT(relativeError(set.contributions[5], operation.place(), 2), .01);
}

TEST(Place, ALampThatComesNearerKeepsItsPower) {
  std::vector<LampPlace> near = kFive;
  for (LampPlace& place : near) place.distance = 4;
  const LitBall ball = test::ballUnder(near, kLevels);
  const LampPlace there{near[1].azimuth, near[1].elevation, 2, {}};
  const SolvedSet set = edited(ball, placed(PlaceOperation::at(there), "lamp1", placesOf(ball)));
  EXPECT_LT(relativeError(set.contributions[1], there, 4 * kLevels[1]), .01);
}

TEST(Place, SurfacesThatThreeLampsDoNotLightAreAGuess) {
  LitBall ball = test::ballUnder(kFive, kLevels);
  for (size_t lamp = 0; lamp < 3; ++lamp)
    std::fill_n(ball.shadows[lamp].labels.begin(), 10 * kBallWidth, ShadowLabel::Umbra);
  const auto surfaces = surfaceSource(std::shared_ptr<const SolvedSet>(std::shared_ptr<void>(), &ball.set),
                                      ball.source(), placesOf(ball))();
  EXPECT_EQ(surfaces->guessed[5 * kBallWidth + 48], 1);
  EXPECT_EQ(surfaces->guessed[48 * kBallWidth + 48], 0);
  for (size_t p = 0; p < surfaces->guessed.size(); ++p) {
    double square = 0;
    for (int c = 0; c < 3; ++c) square += std::pow(surfaces->normals.plane(c)[p], 2);
    ASSERT_NEAR(square, 1, 1e-3);
    ASSERT_TRUE(std::isfinite(surfaces->reflectance.plane(1)[p]) && surfaces->reflectance.plane(1)[p] >= 0);
  }
  // Continued from the wall below, which faces the camera.
  EXPECT_GT(surfaces->normals.plane(2)[5 * kBallWidth + 5], .9F);
  EXPECT_NEAR(surfaces->reflectance.plane(1)[5 * kBallWidth + 5], ballPaint(5, 5), .15);
}

TEST(Place, IsFiniteAndNeverNegativeWhereverTheLampIs) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  for (const PlaceOperation& operation : {PlaceOperation{180, 90, 0, 4}, PlaceOperation{-180, -90, 1000, 0},
                                          PlaceOperation{90, 0, .3F, 0}, PlaceOperation{0, 0, .01F, 1}})
    for (const char* light : {"lamp1", "new"}) {
      EditStack stack = placed(operation, light, placesOf(ball));
      stack.newLights = {"new"};
      for (const Image& image : edited(ball, stack).contributions)
        for (int c = 0; c < 3; ++c)
          for (size_t p = 0; p < image.pixelCount(); ++p)
            ASSERT_TRUE(std::isfinite(image.plane(c)[p]) && image.plane(c)[p] >= 0) << operation.azimuth;
    }
}

TEST(Place, ALargeLampLightsAroundCorners) {
  const float nx[] = {0, std::sin(1.55F), 1, std::sin(1.6F)};
  const float ny[] = {0, 0, 0, 0};
  const float nz[] = {1, std::cos(1.55F), 0, std::cos(1.6F)};
  float small[4];
  float large[4];
  const NormalRow row{{nx, ny, nz}, 0, 0, 0};
  PlacedLamp({0, 0, {}, {}}, 0).shadeRow(row, 4, small);
  PlacedLamp({0, 0, {}, {}}, 1).shadeRow(row, 4, large);
  EXPECT_FLOAT_EQ(small[0], 1);
  EXPECT_FLOAT_EQ(large[0], 1);  // it is not brighter
  EXPECT_EQ(small[3], 0);
  EXPECT_GT(large[3], .05F);
  EXPECT_GT(large[1], small[1]);
}

TEST(Place, SaysWhatIsMissing) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  const auto refusal = [&](const LampPlaces& places) -> std::string {
    try {
      static_cast<void>(edited(ball, placed(PlaceOperation{}, "lamp1", places)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  LampPlaces places = placesOf(ball);
  EXPECT_EQ(refusal(places), "");
  places.erase("lamp1");
  EXPECT_THAT(refusal(places), testing::HasSubstr("nobody has said where its lamp stood"));
  EXPECT_THAT(refusal({}), testing::HasSubstr("0 of 3 are known"));
  places["lamp7"] = {};
  EXPECT_THAT(refusal(places), testing::HasSubstr("lamp7"));
  places = placesOf(ball);
  places["lamp0"].stops = {};
  EXPECT_THAT(refusal(places), testing::HasSubstr("say the stops of all lamps, or of none"));
  places = placesOf(ball);
  for (auto& [light, place] : places) place.distance = 1;
  EXPECT_THAT(refusal(places), testing::HasSubstr("nearer than 2 widths"));
}

TEST(Place, IsRefusedWhereHardlyAnySurfaceIsKnown) {
  LitBall ball = test::ballUnder(kFive, kLevels);
  for (size_t lamp = 0; lamp < 3; ++lamp)
    std::fill_n(ball.shadows[lamp].labels.begin(), 80 * kBallWidth, ShadowLabel::Umbra);
  try {
    static_cast<void>(edited(ball, placed(PlaceOperation{}, "lamp1", placesOf(ball))));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("can be told on 1"));
  }
}

TEST(Place, TilesAreTheWholePicture) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  EditStack stack = placed(PlaceOperation{10, 40, 3, .5F}, "lamp1", placesOf(ball));
  stack.newLights = {"new"};
  Edit another = *stack.edits[0];
  another.lights = {"new"};
  another.mask = {{EllipseShape{40, 50, 30, 20, 8}, false}};
  stack.append(another);
  const std::shared_ptr<const SolvedSet> set(std::shared_ptr<void>(), &ball.set);
  EditedSet tiles(set, ball.source(), [&] { return surfaceSource(set, ball.source(), stack.lampPlaces)(); });
  tiles.setStack(stack);
  tiles.update();
  const SolvedSet whole = edited(ball, stack);
  for (size_t i = 0; i < whole.contributions.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < whole.contributions[i].pixelCount(); ++p)
        ASSERT_NEAR(tiles.result().contributions[i].plane(c)[p], whole.contributions[i].plane(c)[p], 2e-6);
}

TEST(Place, AnotherPlaceThatIsToldChangesTheResult) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  EditStack stack = placed(PlaceOperation{10, 40, 0, 0}, "lamp1", placesOf(ball));
  const std::shared_ptr<const SolvedSet> set(std::shared_ptr<void>(), &ball.set);
  EditedSet tiles(set, ball.source(), [&] { return surfaceSource(set, ball.source(), stack.lampPlaces)(); });
  tiles.setStack(stack);
  tiles.update();
  const float before = tiles.result().contributions[1].view().at(0, 30, 30);
  stack.lampPlaces["lamp1"].azimuth += 8;
  tiles.setStack(stack);
  tiles.update();
  EXPECT_NE(tiles.result().contributions[1].view().at(0, 30, 30), before);
}

TEST(Place, OtherSurfacesThatWereFoundChangeTheResult) {
  const LitBall ball = test::ballUnder(kFive, kLevels);
  const EditStack stack = placed(PlaceOperation{10, 40, 0, 0}, "lamp1", placesOf(ball));
  const std::shared_ptr<const SolvedSet> set(std::shared_ptr<void>(), &ball.set);
  LampPlaces by = stack.lampPlaces;
  EditedSet tiles(set, ball.source(), [&] { return surfaceSource(set, ball.source(), by)(); });
  tiles.setStack(stack);
  tiles.update();
  const float before = tiles.result().contributions[1].view().at(0, 30, 30);
  by["lamp2"].azimuth += 15;
  tiles.setStack(stack);
  tiles.update();
  EXPECT_EQ(tiles.result().contributions[1].view().at(0, 30, 30), before);
  tiles.surfacesChanged();
  tiles.setStack(stack);
  tiles.update();
  EXPECT_NE(tiles.result().contributions[1].view().at(0, 30, 30), before);
}

}  // namespace
}  // namespace swaplight
