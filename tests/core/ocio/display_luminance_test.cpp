#include "core/ocio/display_luminance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

DisplayLuminance luminanceOf(const DisplayChoice& choice) {
  return {ColorConfig(""), choice};
}

TEST(DisplayLuminance, IsThatOfTheStandards) {
  const DisplayLuminance srgb = luminanceOf({"sRGB", "sRGB"});
  ASSERT_TRUE(srgb.known());
  EXPECT_NEAR(srgb.nits(1), 100, .01);
  EXPECT_NEAR(srgb.nits(.5F), 100 * std::pow((.5 + .055) / 1.055, 2.4), .02);  // IEC 61966-2-1
  const DisplayLuminance bt1886 = luminanceOf({"Rec.709", "ACES SDR"});
  EXPECT_NEAR(bt1886.nits(.5F), 100 * std::pow(.5, 2.4), .02);
  // SMPTE ST 2084, its codes of 100, 1000 and 10000 cd/m2.
  const DisplayLuminance pq = luminanceOf({"Rec.2100 PQ", "203 nit white"});
  EXPECT_NEAR(pq.nits(.508078F), 100, .2);
  EXPECT_NEAR(pq.nits(.751827F), 1000, 2);
  EXPECT_NEAR(pq.nits(1), 10000, 20);
}

TEST(DisplayLuminance, OfACodeThatShowsNitsIsTheseNits) {
  for (const DisplayChoice& choice : {DisplayChoice{"sRGB", "sRGB"}, {"Rec.2100 PQ", "203 nit white"}}) {
    const DisplayLuminance shown = luminanceOf(choice);
    for (const float nits : {1.F, 10.F, 48.F, 99.F})
      EXPECT_NEAR(shown.nits(shown.code(nits)), nits, 1e-3 * nits);
    EXPECT_EQ(shown.code(0), 0);
    EXPECT_EQ(shown.code(20000), 1);
  }
}

TEST(DisplayLuminance, IsNotKnownOfCodesThatAreNoDisplays) {
  EXPECT_FALSE(luminanceOf({"sRGB", "Log"}).known());
  EXPECT_FALSE(luminanceOf({"sRGB", "Raw"}).known());
  EXPECT_FALSE(DisplayLuminance().known());
}

TEST(DisplayLuminance, IsNotKnownWhereTheDisplaysTransformHasNoInverse) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder / "config.ocio", R"(ocio_profile_version: 2
roles: {default: lin, scene_linear: lin}
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  monitor:
    - !<View> {name: grey, view_transform: plain, display_colorspace: shown}
view_transforms:
  - !<ViewTransform>
    name: plain
    from_scene_reference: !<MatrixTransform> {matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}
display_colorspaces:
  - !<ColorSpace>
    name: shown
    from_display_reference: !<MatrixTransform> {matrix: [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]}
colorspaces:
  - !<ColorSpace> {name: lin, isdata: false}
)");
  const ColorConfig config((folder / "config.ocio").string());
  config.checkView({"monitor", "grey"});
  EXPECT_FALSE(DisplayLuminance(config, {"monitor", "grey"}).known());
  EXPECT_FALSE(DisplayLuminance(config, {"monitor", "none"}).known());
}

}  // namespace
}  // namespace swaplight
