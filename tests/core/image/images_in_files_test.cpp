#include "core/image/images_in_files.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "core/image/image.h"
#include "tests/support/temporary_folder.h"

namespace swaplight::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
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

/// A program that is killed meanwhile leaves nothing either.
TEST(ImagesInFiles, FilesNeverHaveAName) {
  const TemporaryFolder folder;
  const int canDo = ::open(folder.path().c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (canDo < 0) GTEST_SKIP() << "SKIPPED: " << folder.path() << " has no files without names";
  ::close(canDo);
  const ImagesInFiles files(folder.path(), kBytes);
  const int changes = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  ASSERT_GE(::inotify_add_watch(changes, folder.path().c_str(), IN_CREATE | IN_DELETE), 0);
  const Image image(ImageSpec::rgb(640, 480));
  std::array<char, 4096> seen{};
  EXPECT_LT(::read(changes, seen.data(), seen.size()), 0);
  ::close(changes);
}

/// Files in memory make no room while a signal waits: Ctrl-C, which the program then hears of elsewhere.
TEST(ImagesInFiles, SignalsWhileRoomIsMadeAreNoFault) {
  const std::filesystem::path inMemory = "/dev/shm";
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(inMemory, error);
  if (error || space.available < size_t{256} << 20) GTEST_SKIP() << "SKIPPED: no 256 MiB in " << inMemory;
  const ImagesInFiles files(inMemory, kBytes);
  const auto before = ::signal(SIGUSR1, [](int) {});
  {
    const std::jthread signals([here = ::pthread_self()] {
      for (int i = 0; i < 8; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        ::pthread_kill(here, SIGUSR1);
      }
    });
    EXPECT_NO_THROW(Image(ImageSpec::rgb(4096, 4096)));
  }
  ::signal(SIGUSR1, before);
}

TEST(ImagesInFiles, SaysWhereTheyCannotLie) {
  const ImagesInFiles files("/nowhere/at/all", kBytes);
  const std::string message = inputError([] { const Image image(ImageSpec::rgb(640, 480)); });
  EXPECT_THAT(message, StartsWith("/nowhere/at/all: "));
  EXPECT_THAT(message, Not(HasSubstr("space")));
}

}  // namespace
}  // namespace swaplight::test
