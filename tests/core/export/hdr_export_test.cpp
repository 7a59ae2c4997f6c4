#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "core/export/frame_export.h"
#include "core/export/layer_export.h"
#include "core/image/io/image_io.h"
#include "core/measure/delta_e.h"
#include "core/relight/relight.h"
#include "core/relight/setting.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using Color = std::array<double, 3>;

/// A colour at its brightest that a display shows, without its intensity: what is left is its chromaticity.
Lab chromaticity(const Color& color) {
  const double most = std::max({color[0], color[1], color[2]});
  return labFromLinearRec709(color[0] / most, color[1] / most, color[2] / most);
}

/// The largest CIEDE2000 between the chromaticities of a file and of the product computed in double.
double worstHue(const std::filesystem::path& file, const SolvedSet& set, const Rig& rig, double* brightest) {
  const Image written = readImage(file).image;
  const std::vector<Rgb> factors = rigFactors(test::builtinColors(), rig, set.colorSpace());
  double worst = 0;
  *brightest = 0;
  for (size_t p = 0; p < written.pixelCount(); ++p) {
    Color exact{}, found{};
    for (size_t c = 0; c < 3; ++c) {
      const int channel = static_cast<int>(c);
      found[c] = written.plane(channel)[p];
      for (size_t i = 0; i < set.contributions.size(); ++i)
        exact[c] += double{factors[i][channel]} * set.contributions[i].plane(channel)[p];
      *brightest = std::max(*brightest, exact[c]);
      EXPECT_NEAR(found[c], exact[c], 1e-3 * exact[c]) << "nothing is clipped";
    }
    if (*std::max_element(exact.begin(), exact.end()) > 0)
      worst = std::max(worst, deltaE2000(chromaticity(found), chromaticity(exact)));
  }
  return worst;
}

Rig tenStopsMore(const SolvedSet& set) {
  Rig rig = defaultRig(set.capture);
  applySetting(rig.lights[0], "rgb:1/0.25/0.03,+10st");
  applySetting(rig.lights[1], "-10st");
  return rig;
}

TEST(HdrExport, AKeyTenStopsUpKeepsItsHueAndIsNotClipped) {
  const test::TemporaryFolder folder;
  const SolvedSet set = test::smallSet(2, 64, 40);
  const Rig rig = tenStopsMore(set);
  exportFrame(test::builtinColors(), set, rig, folder / "frame.exr", {});
  double brightest = 0;
  const double worst = worstHue(folder / "frame.exr", set, rig, &brightest);
  EXPECT_GT(brightest, 500);
  EXPECT_LE(worst, 0.5);
  RecordProperty("dE00", std::to_string(worst));
  EXPECT_EQ(readImage(folder / "frame.exr").info.pixelType, "half");
}

TEST(HdrExport, LightBrighterThanHalfCanHoldIsWrittenAsFloat) {
  const test::TemporaryFolder folder;
  SolvedSet set = test::smallSet(2, 64, 40);
  for (Image& contribution : set.contributions)
    for (int c = 0; c < 3; ++c)
      std::transform(contribution.plane(c), contribution.plane(c) + contribution.pixelCount(),
                     contribution.plane(c), [](float v) { return 500 * v; });
  const Rig rig = tenStopsMore(set);
  exportFrame(test::builtinColors(), set, rig, folder / "frame.exr", {});
  double brightest = 0;
  EXPECT_LE(worstHue(folder / "frame.exr", set, rig, &brightest), 0.5);
  EXPECT_GT(brightest, 100000);
  EXPECT_EQ(readImage(folder / "frame.exr").info.pixelType, "float");
  exportLayers(test::builtinColors(), set, rig, folder / "layers.exr", {});
  EXPECT_LE(worstHue(folder / "layers.exr", set, rig, &brightest), 0.5);
}

TEST(FrameExport, CanBeStoppedWhileItIsWrittenAndLeavesNothing) {
  const test::TemporaryFolder folder;
  const SolvedSet set = test::smallSet(2, 64, 1500);
  std::atomic<bool> stop = false;
  float last = 0;
  Progress progress;
  progress.stop = &stop;
  progress.report = [&](float fraction, std::string_view what) {
    last = fraction;
    if (what == "writing" && fraction > 0.6F) stop = true;
  };
  EXPECT_THROW(
      exportFrame(test::builtinColors(), set, defaultRig(set.capture), folder / "frame.exr", {}, progress),
      Stopped);
  EXPECT_LT(last, 0.95F);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(HdrExport, RadianceKeepsEightBitsOfTheBrightestChannel) {
  const test::TemporaryFolder folder;
  const SolvedSet set = test::smallSet(2, 64, 40);
  const Rig rig = tenStopsMore(set);
  exportFrame(test::builtinColors(), set, rig, folder / "frame.hdr", {});
  const Image written = readImage(folder / "frame.hdr").image;
  const Image exact = relight(set, rigFactors(test::builtinColors(), rig, set.colorSpace()), rig.ambient);
  for (size_t p = 0; p < exact.pixelCount(); ++p) {
    const float most = std::max({exact.plane(0)[p], exact.plane(1)[p], exact.plane(2)[p]});
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(written.plane(c)[p], exact.plane(c)[p], most / 128) << p;
  }
}

}  // namespace
}  // namespace swaplight
