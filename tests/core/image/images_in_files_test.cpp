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
#include <fstream>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/image/image.h"
#include "core/image/io/image_format.h"
#include "tests/support/temporary_folder.h"

namespace swaplight::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr size_t kBytes = size_t{3} * 4 * 100 * 100;
constexpr ImageMemory kOne{.largest = kBytes};

TEST(ImagesInFiles, HoldsWhatIsLargerAndNothingElse) {
  const TemporaryFolder folder;
  std::optional<ImagesInFiles> files(std::in_place, folder.path(), ImageMemory{.largest = kBytes});
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
  const ImagesInFiles files(folder.path(), kOne);
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

TEST(ImagesInFiles, HoldsWhatIsTooMuchTogether) {
  const TemporaryFolder folder;
  const ImageSpec spec = ImageSpec::rgb(500, 400);  // 2.4 MB
  const Image before(spec, 1);
  const ImagesInFiles files(folder.path(), {.all = 12'000'000});
  std::vector<Image> images;
  for (int j = 0; j < 8; ++j) images.emplace_back(spec, float(j));
  EXPECT_GE(ImagesInFiles::count(), 4U) << "of nine, five fit";
  EXPECT_LE(ImagesInFiles::count(), 5U);
  const size_t held = ImagesInFiles::count();
  images.erase(images.begin(), images.begin() + 2);
  images.emplace_back(spec, 1.0F);
  EXPECT_EQ(ImagesInFiles::count(), held) << "there is room again";
  const Image small(ImageSpec::rgb(100, 100), 1);
  EXPECT_EQ(ImagesInFiles::count(), held) << "not worth a file";
  for (int j = 2; j < 8; ++j) EXPECT_EQ(images[size_t(j) - 2].plane(2)[1], float(j));
}

/// Bytes of files in this program's memory.
long heldOfFiles() {
  long all = 0, resident = 0, ofFiles = 0;
  std::ifstream("/proc/self/statm") >> all >> resident >> ofFiles;
  return ofFiles * ::sysconf(_SC_PAGESIZE);
}

TEST(ImagesInFiles, HandsBackWhatWasTouched) {
  const TemporaryFolder folder;
  const long before = heldOfFiles();
  constexpr long kMost = 4L << 20;
  const ImagesInFiles files(folder.path(), {.largest = kBytes, .ofFiles = size_t{kMost}});
  const Image image(ImageSpec::rgb(2048, 2048), 1);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (heldOfFiles() > before + 2 * kMost && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_LE(heldOfFiles(), before + 2 * kMost) << "of 48 MiB";
  EXPECT_EQ(image.plane(2)[2048 * 2047], 1);
}

TEST(ImagesInFiles, ASetMayBeLargerThanTheMemory) {
  const double memory = 1e9 * machineGigabytes();
  const int side = 1 << 14, channels = int(memory / 4 / side / side) + 1;  // as much as the memory
  EXPECT_THROW(checkImageFits("set.exr", side, side, channels), InputError);
  const TemporaryFolder folder;
  {
    const ImagesInFiles large(folder.path(), kOne);
    EXPECT_THROW(checkImageFits("set.exr", side, side, channels), InputError)
        << "nothing bounds them together";
  }
  const ImagesInFiles files(folder.path(), {.all = kBytes});
  EXPECT_NO_THROW(checkImageFits("set.exr", side, side, channels));
  EXPECT_THROW(checkImageFits("set.exr", side, side, 9 * channels), InputError) << "it would fill the disk";
  EXPECT_THROW(checkImageFits("set.exr", (1 << 17) + 1, 1, 1), InputError) << "no picture is so long";
  EXPECT_THROW(checkBandFits("set.exr", size_t(.3 * memory)), InputError) << "is decoded in memory";
  EXPECT_NO_THROW(checkBandFits("set.exr", size_t(.2 * memory)));
}

TEST(ImagesInFiles, LeavesNoFileBehind) {
  const TemporaryFolder folder;
  const ImagesInFiles files(folder.path(), kOne);
  const Image image(ImageSpec::rgb(640, 480));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// A program that is killed meanwhile leaves nothing either.
TEST(ImagesInFiles, FilesNeverHaveAName) {
  const TemporaryFolder folder;
  const int canDo = ::open(folder.path().c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (canDo < 0) GTEST_SKIP() << "SKIPPED: " << folder.path() << " has no files without names";
  ::close(canDo);
  const ImagesInFiles files(folder.path(), kOne);
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
  const ImagesInFiles files(inMemory, kOne);
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
  const ImagesInFiles files("/nowhere/at/all", kOne);
  const std::string message = inputError([] { const Image image(ImageSpec::rgb(640, 480)); });
  EXPECT_THAT(message, StartsWith("/nowhere/at/all: "));
  EXPECT_THAT(message, Not(HasSubstr("space")));
}

}  // namespace
}  // namespace swaplight::test
