#include "core/export/layer_export.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/image/io/image_io.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

/// Two lights of this radiance everywhere.
SolvedSet evenSet(float radiance) {
  SolvedSet set = test::smallSet(2, 8, 4);
  for (Image& light : set.contributions)
    for (int c = 0; c < 3; ++c) std::fill_n(light.plane(c), light.pixelCount(), radiance);
  updateBeta(set);
  return set;
}

PixelType typeOf(const ImageFile& file, const std::string& channel) {
  return file.info.channelTypes.at(static_cast<size_t>(file.image.channelIndex(channel)));
}

TEST(LayerExport, ASumThatIsTooBrightForHalfIsFloatAndStaysTheSumOfItsLayers) {
  const test::TemporaryFolder folder;
  const SolvedSet set = evenSet(40000);
  const PixelType type =
      exportLayers(test::builtinColors(), set, defaultRig(set.capture), folder / "layers.exr", {});
  EXPECT_EQ(type, PixelType::Half) << "of the lights";
  const ImageFile file = readImage(folder / "layers.exr");
  EXPECT_EQ(typeOf(file, "R"), PixelType::Float);
  EXPECT_EQ(typeOf(file, "light1.R"), PixelType::Half);
  const auto value = [&](const std::string& channel) {
    return file.image.plane(file.image.channelIndex(channel))[5];
  };
  for (const std::string c : {"R", "G", "B"})
    EXPECT_EQ(value(c), value("light1." + c) + value("light2." + c));
}

TEST(LayerExport, HighlightsThatOtherPrimariesMakeTooBrightForHalfAreFloat) {
  const test::TemporaryFolder folder;
  SolvedSet set = evenSet(30000);
  for (Image& light : set.contributions) {
    light.setColorSpace("acescg");
    Image& red = set.highlights.emplace_back(light.clone());  // 30000 of AP1's red: 51000 of Rec. 709's
    for (int c = 1; c < 3; ++c) std::fill_n(red.plane(c), red.pixelCount(), 0.F);
  }
  Rig rig = defaultRig(set.capture);
  rig.lights[0].stops = 1;  // the light itself is 60000
  LayerOptions options;
  options.colorSpace = "lin_rec709";
  options.highlights = true;
  exportLayers(test::builtinColors(), set, rig, folder / "layers.exr", options);
  const ImageFile file = readImage(folder / "layers.exr");
  EXPECT_EQ(typeOf(file, "light1.R"), PixelType::Half);
  EXPECT_EQ(typeOf(file, "light1.spec.R"), PixelType::Float);
  EXPECT_GT(file.image.plane(file.image.channelIndex("light1.spec.R"))[5], 100000);
}

}  // namespace
}  // namespace swaplight
