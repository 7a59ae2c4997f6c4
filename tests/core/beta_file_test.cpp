#include "core/edit/beta_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/image/image_io.h"
#include "tests/core/small_set.h"
#include "tests/core/temporary_folder.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

TEST(BetaFile, ExrKeepsEveryLightToTheBit) {
  const test::TemporaryFolder folder;
  const SolvedSet set = test::smallSet(3, 40, 30);
  const auto files = writeBetaMaps(set, folder / "beta.exr");
  ASSERT_EQ(files.size(), 1u);
  for (int i = 0; i < 3; ++i) {
    const std::string light = set.capture.lights[static_cast<size_t>(i)].name;
    const Image beta = readBetaMap(files[0], "", light, 40, 30);
    EXPECT_TRUE(std::equal(beta.plane(0), beta.plane(0) + beta.pixelCount(), set.beta.plane(i)));
    EXPECT_TRUE(std::equal(beta.plane(0), beta.plane(0) + beta.pixelCount(),
                           readBetaMap(files[0], "beta." + light, "other", 40, 30).plane(0)));
  }
}

TEST(BetaFile, PngHasAFileALightAndSixteenBits) {
  const test::TemporaryFolder folder;
  const SolvedSet set = test::smallSet(2, 40, 30);
  const auto files = writeBetaMaps(set, folder / "beta.png");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[1].filename(), "beta.light2.png");
  const Image beta = readBetaMap(files[1], "", "light2", 40, 30);
  for (size_t p = 0; p < beta.pixelCount(); ++p) ASSERT_NEAR(beta.plane(0)[p], set.beta.plane(1)[p], 1e-5);
}

TEST(BetaFile, ChecksSizeChannelAndRange) {
  const test::TemporaryFolder folder;
  Image map(ImageSpec{4, 4, {"Y"}, "data"}, .5f);
  const auto read = [&](int width, const std::string& channel) {
    writeImage(map, folder / "map.exr");
    return test::inputError([&] { (void)readBetaMap(folder / "map.exr", channel, "key", width, 4); });
  };
  EXPECT_THAT(read(5, ""), testing::AllOf(HasSubstr("4 x 4"), HasSubstr("5 x 4")));
  EXPECT_THAT(read(4, "beta.fill"), testing::AllOf(HasSubstr("beta.fill"), HasSubstr("Y")));
  map.plane(0)[6] = 1.5f;
  EXPECT_THAT(read(4, ""), testing::AllOf(HasSubstr("2, 1"), HasSubstr("1.5")));
  map.plane(0)[6] = NAN;
  EXPECT_THAT(read(4, ""), HasSubstr("2, 1"));
}

}  // namespace
}  // namespace swaplight
