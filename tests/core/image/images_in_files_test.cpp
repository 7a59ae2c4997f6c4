#include "core/image/images_in_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "core/image/image.h"
#include "tests/support/temporary_folder.h"

namespace swaplight::test {
namespace {

using ::testing::StartsWith;

constexpr size_t kBytes = size_t{3} * 4 * 100 * 100;

TEST(ImagesInFiles, HoldsWhatIsLargerAndNothingElse) {
  const TemporaryFolder folder;
  std::optional<ImagesInFiles> files(std::in_place, folder.path(), kBytes);
  const Image small(ImageSpec::rgb(100, 100), 1);
  EXPECT_EQ(ImagesInFiles::count(), 0U);
  std::optional<Image> large(std::in_place, ImageSpec::rgb(101, 100), 2.0F);
  EXPECT_EQ(ImagesInFiles::count(), 1U);
  files.reset();
  const Image inMemory(ImageSpec::rgb(101, 100), 3);
  EXPECT_EQ(ImagesInFiles::count(), 1U);
  large.reset();
  EXPECT_EQ(ImagesInFiles::count(), 0U);
}

TEST(ImagesInFiles, PixelsStayWhileTheirMemoryIsHandedBack) {
  const TemporaryFolder folder;
  const ImagesInFiles files(folder.path(), kBytes);
  Image image(ImageSpec::rgb(640, 480));
  for (int turn = 0; turn < 5; ++turn) {
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p) image.plane(c)[p] = static_cast<float>(p + turn);
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p)
        ASSERT_EQ(image.plane(c)[p], static_cast<float>(p + turn));
  }
}

TEST(ImagesInFiles, LeavesNoFileBehind) {
  const TemporaryFolder folder;
  const ImagesInFiles files(folder.path(), kBytes);
  const Image image(ImageSpec::rgb(640, 480));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ImagesInFiles, SaysWhereTheyCannotLie) {
  const ImagesInFiles files("/nowhere/at/all", kBytes);
  EXPECT_THAT(inputError([] { const Image image(ImageSpec::rgb(640, 480)); }),
              StartsWith("/nowhere/at/all: "));
}

}  // namespace
}  // namespace swaplight::test
