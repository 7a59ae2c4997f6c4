#include "core/file/atomic_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <set>
#include <thread>

#include "core/base/machine_error.h"
#include "core/image/io/image_io.h"
#include "core/set/solved_file.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using test::TemporaryFolder;
using ::testing::HasSubstr;

TEST(AtomicFile, ReplacesTheTargetOnlyWhenCommitted) {
  const TemporaryFolder folder;
  writeFile(folder / "a.txt", "old");
  {
    const AtomicFile file(folder / "a.txt");
    test::writeBytes(file.temporary(), "half of the n");
    EXPECT_EQ(file.temporary().extension(), ".txt");
    EXPECT_EQ(test::readBytes(folder / "a.txt"), "old");
  }
  EXPECT_EQ(folder.fileCount(), 1U) << "abandoned, the temporary goes";
  writeFile(folder / "a.txt", "new");
  EXPECT_EQ(test::readBytes(folder / "a.txt"), "new");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(AtomicFile, FollowsSymbolicLinks) {
  const TemporaryFolder folder;
  writeFile(folder / "real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  writeFile(folder / "link.txt", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(readFile(folder / "real.txt", 100), "new");
}

TEST(AtomicFile, NeverReplacesFoldersOrDevices) {
  const TemporaryFolder folder;
  EXPECT_THAT(inputError([&] { writeFile(folder.path(), "x"); }), HasSubstr("is a folder"));
  EXPECT_THAT(inputError([&] { writeFile("/dev/null", "x"); }), HasSubstr("is no regular file"));
  EXPECT_THAT(inputError([&] { writeFile(folder / "a/", "x"); }), HasSubstr("names a folder"));
  EXPECT_THAT(inputError([&] { writeFile("/proc/a.txt", "x"); }),
              HasSubstr("/proc/a.txt: cannot be written"));
}

TEST(AtomicFile, ReadingSaysWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_THAT(inputError([&] { (void)readFile(folder / "none", 10); }), HasSubstr("no such file"));
  EXPECT_THAT(inputError([&] { (void)readFile(folder.path(), 10); }), HasSubstr("is a folder"));
  writeFile(folder / "long", std::string(100, 'x'));
  EXPECT_THAT(inputError([&] { (void)readFile(folder / "long", 99); }), HasSubstr("is larger than"));
}

TEST(AtomicFile, KeepsTheModeOfTheFileThatItReplaces) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  writeFile(folder / "a.txt", "old");
  fs::permissions(folder / "a.txt", fs::perms(0640));
  writeFile(folder / "a.txt", "new");
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(), fs::perms(0640));
}

TEST(AtomicFile, AReadOnlyFileIsNotReplaced) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  writeFile(folder / "a.txt", "old");
  fs::permissions(folder / "a.txt", fs::perms(0444));
  EXPECT_THAT(inputError([&] { writeFile(folder / "a.txt", "new"); }), HasSubstr("a.txt: is read-only"));
  EXPECT_EQ(test::readBytes(folder / "a.txt"), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(AtomicFile, ItsTemporaryNameIsAnotherEachTimeAndNoLinkIsFollowed) {
  const TemporaryFolder folder;
  std::set<std::filesystem::path> names;
  for (int i = 0; i < 20; ++i) {
    const AtomicFile file(folder / "a.txt");
    names.insert(file.temporary());
  }
  EXPECT_EQ(names.size(), 20U);
  // Somebody puts a link in the place of the temporary: what it names stays as it was.
  writeFile(folder / "precious", "precious");
  AtomicFile file(folder / "a.txt");
  std::filesystem::remove(file.temporary());
  std::filesystem::create_symlink("precious", file.temporary());
  EXPECT_THROW(file.commit(), MachineError);
  EXPECT_EQ(test::readBytes(folder / "precious"), "precious");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
}

TEST(AtomicFile, TemporariesCanBeRemovedAllAtOnce) {
  const TemporaryFolder folder;
  writeFile(folder / "done.txt", "done");
  const AtomicFile a(folder / "a.txt");
  const AtomicFile b(folder / "b.txt");
  removeTemporaryFiles();
  EXPECT_EQ(folder.fileCount(), 1U);
  EXPECT_EQ(test::readBytes(folder / "done.txt"), "done");
}

TEST(AtomicFile, ReadingNeverWaitsForAWriterThatIsNotThere) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo.json").c_str(), 0600), 0);
  EXPECT_THAT(inputError([&] { (void)readFile(folder / "fifo.json", 10); }),
              HasSubstr("is a pipe that nobody writes to"));
  EXPECT_THAT(inputError([&] { (void)readFile("/dev/zero", 10); }), HasSubstr("is no regular file"));
}

TEST(AtomicFile, APipeThatSomebodyWritesToIsRead) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo.json").c_str(), 0600), 0);
  const int keep = ::open((folder / "fifo.json").c_str(), O_RDWR);
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(::write(keep, "{}", 2), 2);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ::close(keep);
  });
  EXPECT_EQ(readFile(folder / "fifo.json", 10), "{}");
  writer.join();
}

/// A disk of 256 KiB.
class SmallDisk : public ::testing::Test {
 protected:
  void SetUp() override {
    m_mounted = ::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=256k") == 0;
    if (!m_mounted) GTEST_SKIP() << "no permission to mount a small disk";
  }
  void TearDown() override {
    if (m_mounted) ::umount2(folder.path().c_str(), MNT_DETACH);
  }
  TemporaryFolder folder;

 private:
  bool m_mounted = false;
};

TEST_F(SmallDisk, AFullDiskIsSaidByEveryWriterAndNothingStaysBehind) {
  Image noise(ImageSpec::rgb(512, 512));
  std::mt19937 random(3);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < noise.pixelCount(); ++p)
      noise.plane(c)[p] = static_cast<float>(random() % 65536) / 65535;
  for (const char* name : {"a.exr", "a.png", "a.tif", "a.hdr", "a.jpg"})
    EXPECT_THAT(inputError([&] { writeImage(noise, folder / name); }), HasSubstr("the disk is full")) << name;
  EXPECT_THAT(inputError([&] { writeFile(folder / "a.json", std::string(300000, 'x')); }),
              HasSubstr("the disk is full"));
  EXPECT_THROW(writeFile(folder / "a.json", std::string(300000, 'x')), MachineError);
  EXPECT_EQ(folder.fileCount(), 0U);
  writeFile(folder / "small.json", "{}");
  EXPECT_EQ(folder.fileCount(), 1U);
}

}  // namespace
}  // namespace swaplight
