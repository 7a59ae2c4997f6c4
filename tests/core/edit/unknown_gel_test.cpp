#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/edit/apply/edited_set.h"
#include "core/edit/apply/gel_mixing.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::smallSet;
using testing::HasSubstr;
using Lamps = UnknownGelOperation::Lamps;

constexpr Rgb kKnown{.9F, .5F, .3F}, kSecondLamp{.85F, .52F, .31F};  ///< the gel in either lamp

/// Two lamps that exchanged a known gel and ?a, solved with one of the colours that ?a may have.
SolvedSet swappedSet() {
  SolvedSet set = smallSet(2, 60, 40);
  // Nowhere is one lamp alone: then all colours between both ends are possible.
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
      float &a = set.contributions[0].plane(c)[p], &b = set.contributions[1].plane(c)[p];
      const float sum = a + b;
      a = .3F * a + .35F * sum, b = sum - a;
    }
  set.capture.shots.resize(2);
  for (size_t k = 0; k < 2; ++k) {
    Shot& shot = set.capture.shots[k];
    shot.lightColors = {std::nullopt, std::nullopt};
    shot.lightColors[k] = k == 0 ? kKnown : kSecondLamp;
    shot.colorNames = {k == 0 ? "" : "?a", k == 0 ? "?a" : ""};
  }
  const Rgb known = glm::sqrt(kKnown * kSecondLamp), direction{.3F, -.2F, .1F};
  const auto at = [&](float scale) {
    return known * (Rgb(1) - scale * direction) / (Rgb(1) + scale * direction);
  };
  OpenColor open;
  open.nearest = at(1);
  open.farthest = at(2.5F);
  open.position = 0.25F;
  open.taken = at(1 + .25F * 1.5F);
  open.exchanged = at(-1 - .25F * 1.5F);
  set.report.emplace();
  set.report->openColor = open;
  return set;
}

/// What the two photographs show of it.
float photographed(const SolvedSet& set, int shot, const Rgb& gel, int c, size_t p) {
  const float a = set.contributions[0].plane(c)[p], b = set.contributions[1].plane(c)[p];
  return shot == 0 ? kKnown[c] * a + gel[c] * b : gel[c] * a + kSecondLamp[c] * b;
}

SolvedSet edited(const SolvedSet& set, const UnknownGelOperation& operation) {
  EditStack stack;
  Edit edit;
  edit.operation = operation;
  stack.append(edit);
  return applyEdits(set, stack);
}

TEST(UnknownGel, LeavesBothPhotographsAsTheyAre) {
  const SolvedSet set = swappedSet();
  for (const float position : {0.F, .25F, .6F})
    for (const Lamps lamps : {Lamps::AsSolved, Lamps::Exchanged}) {
      const UnknownGelOperation operation{position, lamps};
      const SolvedSet other = edited(set, operation);
      const Rgb gel = gelMixing(set, operation).color;
      size_t clamped = 0, compared = 0;
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
          // Where a lamp would give less than nothing, the photographs say that it is not this colour.
          if (other.contributions[0].plane(c)[p] <= 0 || other.contributions[1].plane(c)[p] <= 0) {
            ++clamped;
            continue;
          }
          ++compared;
          for (int shot = 0; shot < 2; ++shot)
            ASSERT_NEAR(photographed(other, shot, gel, c, p),
                        photographed(set, shot, set.report->openColor->taken, c, p), 2e-5)
                << position;
        }
      EXPECT_GT(compared, 4 * clamped) << position;
    }
}

TEST(UnknownGel, IsTheSetAsSolvedWhereItStands) {
  const SolvedSet set = swappedSet();
  const auto solved = solvedGel(set);
  ASSERT_TRUE(solved);
  EXPECT_EQ(solved->position, .25F);
  const SolvedSet same = edited(set, *solved);
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p)
        ASSERT_NEAR(same.contributions[i].plane(c)[p], set.contributions[i].plane(c)[p], 1e-5);
  const Rgb color = gelMixing(set, *solved).color;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], set.report->openColor->taken[c], 1e-5);
  const Rgb exchanged = gelMixing(set, {.25F, Lamps::Exchanged}).color;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(exchanged[c], set.report->openColor->exchanged[c], 1e-4);
}

/// What a gel really was is no colour of a surface, wherever one was recoloured: what a shadow edit adds is
/// the same beside it, and in whatever tiles it is computed.
TEST(UnknownGel, ChangesNoSurfaceBesideOneThatWasRecoloured) {
  const auto set = std::make_shared<const SolvedSet>(swappedSet());
  auto shadows = std::make_shared<LightShadows>();
  shadows->visibility = Image(ImageSpec{60, 40, {"Y"}, "data"}, 0);
  shadows->direct = Image(ImageSpec::rgb(60, 40), .4F);
  shadows->labels.assign(shadows->visibility.pixelCount(), ShadowLabel::Umbra);
  const ShadowSource source = [&](const std::string&) { return shadows; };
  const auto edit = [](const Operation& operation, std::vector<std::string> lights, Mask mask = {}) {
    Edit made;
    made.operation = operation;
    made.lights = std::move(lights);
    made.mask = std::move(mask);
    return made;
  };
  RecolorOperation red;
  red.kind = RecolorOperation::Kind::Color;
  red.to = Rgb(1, .2F, .2F);
  EllipseShape corner{10, 10, 8, 8, 0};
  EditStack plain, recolored;
  for (EditStack* stack : {&plain, &recolored}) {
    stack->append(edit(UnknownGelOperation{.9F, Lamps::AsSolved}, {}));
    if (stack == &recolored) stack->append(edit(red, {}, {{corner, false}}));
    stack->append(edit(ShadowOperation{}, {set->capture.lights[0].name}));
  }
  const SolvedSet one = applyEdits(*set, plain, source);
  const SolvedSet two = applyEdits(*set, recolored, source);
  EditedSet tiles(set, source);
  tiles.setStack(recolored);
  tiles.update();
  size_t changed = 0;
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 60; ++x) {
        const auto at = [&](const SolvedSet& of) { return of.contributions[0].view().at(c, x, y); };
        ASSERT_NEAR(at(tiles.result()), at(two), 1e-6) << x << " " << y;
        if (at(one) == at(two)) continue;
        ++changed;
        ASSERT_LT(std::hypot(float(x) - 10, float(y) - 10), 11) << x << " " << y;
      }
  EXPECT_GT(changed, 100U);
}

TEST(UnknownGel, TakesTheHighlightsAlong) {
  SolvedSet set = swappedSet();
  for (const float part : {.5F, 0.F}) {
    Image& highlight = set.highlights.emplace_back(set.contributions[set.highlights.size()].clone());
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p) highlight.plane(c)[p] *= part;
  }
  const UnknownGelOperation operation{.4F, Lamps::Exchanged};
  const GelMixing mixing = gelMixing(set, operation);
  const SolvedSet other = edited(set, operation);
  for (size_t i = 0; i < 2; ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < set.beta.pixelCount(); ++p) {
        const float light = other.contributions[i].plane(c)[p];
        const float mixed = mixing.factor[c][i][0] * set.highlights[0].plane(c)[p];
        ASSERT_NEAR(other.highlights[i].plane(c)[p], std::clamp(mixed, 0.F, light), 1e-6) << i;
      }
}

TEST(UnknownGel, IsRefusedWhereNothingIsOpen) {
  SolvedSet set = swappedSet();
  set.report->openColor.reset();
  EXPECT_FALSE(solvedGel(set));
  EXPECT_THAT(test::inputError([&] { (void)edited(set, {}); }),
              HasSubstr("no gel of which its photographs leave"));
}

}  // namespace
}  // namespace swaplight
