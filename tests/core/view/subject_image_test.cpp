#include <gtest/gtest.h>

#include <cmath>

#include "core/base/json.h"
#include "core/plot/color_map.h"
#include "core/relight/setting.h"
#include "core/view/probe.h"
#include "core/view/subject_image.h"
#include "tests/support/builtin_colors.h"

namespace swaplight {
namespace {

/// Two lights over two pixels; the second pixel is black under the first light.
SolvedSet smallSet() {
  SolvedSet set;
  for (const char* name : {"key", "fill"}) {
    set.capture.lights.push_back({name, Role::Other, Json::object()});
    set.contributions.emplace_back(ImageSpec::rgb(2, 1), 0.0F);
  }
  for (int c = 0; c < 3; ++c) {
    set.contributions[0].plane(c)[0] = 0.3F;
    set.contributions[1].plane(c)[0] = 0.1F;
    set.contributions[1].plane(c)[1] = 0.18F;
  }
  set.quality = Image(ImageSpec{2, 1, {"residual", "sigma", "flags", "model"}, ""}, 0.0F);
  set.quality.plane(kResidual)[0] = 1;
  set.quality.plane(kSigma)[1] = 0.5F;
  set.quality.plane(kFlags)[1] = kTooDark | kFilled;
  updateBeta(set);
  return set;
}

DisplayTable plainTable() {
  return {nullptr, ViewSettings{}};
}

TEST(SubjectImage, BetaIsTheLightsShare) {
  const Image beta = subjectImage(smallSet(), {ViewSubject::Kind::Beta, 0});
  EXPECT_EQ(beta.channelCount(), 1);
  EXPECT_NEAR(beta.plane(0)[0], 0.75F, 1e-6F);
  EXPECT_EQ(beta.plane(0)[1], 0);
}

TEST(SubjectImage, ReflectanceIsTheSumOfTheLights) {
  const Image reflectance = subjectImage(smallSet(), {ViewSubject::Kind::Reflectance, 0});
  EXPECT_NEAR(reflectance.plane(1)[0], 0.4F, 1e-6F);
  EXPECT_EQ(reflectance.spec().colorSpace, "lin_rec709");
}

TEST(SubjectImage, MapsOfQualityFollowTheirLegends) {
  const SolvedSet set = smallSet();
  const Image residual = subjectImage(set, {ViewSubject::Kind::Residual, 0});
  EXPECT_NEAR(residual.plane(0)[0], viridis(1 / kResidualShown).r, 0.02F);
  EXPECT_NEAR(residual.plane(2)[1], viridis(0).b, 0.02F);
  const Image sigma = subjectImage(set, {ViewSubject::Kind::Sigma, 0});
  EXPECT_NEAR(sigma.plane(0)[1], viridis(1).r, 0.02F) << "what is beyond the scale is its brightest";
  const Image flags = subjectImage(set, {ViewSubject::Kind::Flags, 0});
  EXPECT_EQ(flags.plane(1)[1], kFlagColors[4].color.g);
  EXPECT_LT(flags.plane(1)[0], 0.1F);
  EXPECT_EQ(flagWords(kTooDark | kFilled), "too dark, filled in");
}

TEST(SubjectImage, AnIndexBeyondTheSetBecomesTheLast) {
  const SolvedSet set = smallSet();
  EXPECT_EQ(subjectWithin(set, {ViewSubject::Kind::Beta, 9}).index, 1);
  EXPECT_EQ(subjectWithin(set, {ViewSubject::Kind::Photograph, 0}), ViewSubject{}) << "there are no shots";
}

TEST(SubjectImage, ALightIsItsHighlightAndWhatIsLeft) {
  SolvedSet set = smallSet();
  EXPECT_EQ(subjectWithin(set, {ViewSubject::Kind::Highlight, 1}), ViewSubject{}) << "none is known";
  for (const Image& light : set.contributions) set.highlights.emplace_back(light.spec(), 0.0F);
  set.highlights[0].plane(1)[0] = 0.125F;
  EXPECT_EQ(subjectWithin(set, {ViewSubject::Kind::Highlight, 9}),
            (ViewSubject{ViewSubject::Kind::Highlight, 1}));
  EXPECT_EQ(subjectImage(set, {ViewSubject::Kind::Highlight, 0}).plane(1)[0], 0.125F);
  const Image diffuse = subjectImage(set, {ViewSubject::Kind::Diffuse, 0});
  EXPECT_EQ(diffuse.plane(1)[0], 0.3F - 0.125F);
  EXPECT_EQ(diffuse.plane(0)[0], 0.3F);
  EXPECT_EQ(diffuse.spec().colorSpace, "lin_rec709");
}

TEST(Probe, TellsAPixelUnderTheRig) {
  const SolvedSet set = smallSet();
  Rig rig = defaultRig(set.capture);
  applySetting(rig.lights[0], "-1st");
  const PixelProbe probe =
      probePixels(test::builtinColors(), set, rig, 0, 0, 1, plainTable(), kRec709Luminance);
  EXPECT_NEAR(probe.linear.g, 0.25F, 1e-5F);
  EXPECT_NEAR(probe.stops, std::log2(0.25F / 0.18F), 1e-4F);
  EXPECT_NEAR(probe.shares[0], 0.6F, 1e-4F);
  EXPECT_NEAR(probe.shares[1], 0.4F, 1e-4F);
  EXPECT_EQ(probe.code[0], 64);
  EXPECT_EQ(probe.residual, 1);
}

TEST(Probe, ASquareAtTheEdgeIsTheMeanOfWhatIsThere) {
  const SolvedSet set = smallSet();
  const PixelProbe probe = probePixels(test::builtinColors(), set, defaultRig(set.capture), 1, 0, 9,
                                       plainTable(), kRec709Luminance);
  EXPECT_NEAR(probe.linear.r, 0.29F, 1e-5F);
  EXPECT_EQ(probe.flags, kTooDark | kFilled);
}

TEST(Probe, BlackHasNoStopsAndNoShares) {
  SolvedSet set = smallSet();
  Rig rig = defaultRig(set.capture);
  applySetting(rig.lights[1], "off");
  const PixelProbe probe =
      probePixels(test::builtinColors(), set, rig, 1, 0, 1, plainTable(), kRec709Luminance);
  EXPECT_TRUE(std::isinf(probe.stops));
  EXPECT_EQ(probe.shares[0] + probe.shares[1], 0);
}

}  // namespace
}  // namespace swaplight
