#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "core/base/error.h"
#include "core/session/broken_recovery.h"
#include "core/session/recovery.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr const char* kBroken = R"({"format": "swaplight-session", "version": 1, "source": "a.exr",})";

TEST(KeptWork, ABrokenRecoveryFileIsSetAsideAndNeverDeleted) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "1-1.lock", "");
  test::writeBytes(folder / "1-1.swaplight", kBroken);
  EXPECT_TRUE(findRecovered(folder.path()).empty());
  EXPECT_EQ(test::readBytes(folder / "1-1.swaplight"), kBroken);
  const std::vector<std::string> words = setBrokenAside(folder.path());
  ASSERT_EQ(words.size(), 1U);
  EXPECT_THAT(words[0], HasSubstr("1-1.swaplight: line 1, column"));
  EXPECT_THAT(words[0], HasSubstr("1-1.broken"));
  EXPECT_EQ(test::readBytes(folder / "1-1.broken"), kBroken);
  EXPECT_TRUE(setBrokenAside(folder.path()).empty()) << "said once";
  EXPECT_TRUE(findRecovered(folder.path()).empty());
  EXPECT_EQ(test::readBytes(folder / "1-1.broken"), kBroken);
}

TEST(KeptWork, ABrokenFileOfAProcessThatWasOpeningSomethingIsKeptAsWell) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "1-1.lock", "/sets/heavy.swaplight");
  test::writeBytes(folder / "1-1.swaplight", kBroken);
  const std::vector<Recovered> found = findRecovered(folder.path());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].opening, "/sets/heavy.swaplight");
  discardRecovered(found[0]);
  EXPECT_EQ(test::readBytes(folder / "1-1.swaplight"), kBroken);
}

TEST(KeptWork, AValueThatCannotBeIsBrokenToo) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "1-1.swaplight",
                   R"({"format": "swaplight-session", "version": 1, "recovery_of": 5})");
  EXPECT_TRUE(findRecovered(folder.path()).empty());
  EXPECT_TRUE(fs::exists(folder / "1-1.swaplight"));
}

TEST(KeptWork, ASessionWithoutItsLockIsOffered) {
  const TemporaryFolder folder;
  {
    RecoverySlot slot(folder.path());
    slot.save(Session{}, "/sets/mine.swaplight");
    fs::copy_file(slot.sessionFile(), folder / "7-7.swaplight");
  }
  const std::vector<Recovered> found = findRecovered(folder.path());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].savedAs, "/sets/mine.swaplight");
  discardRecovered(found[0]);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(KeptWork, WhatAnotherStudioIsWritingIsNoRemains) {
  const TemporaryFolder folder;
  test::writeBytes(folder / ".8-8.host-8-0123.tmp.swaplight", "half a sess");
  EXPECT_TRUE(findRecovered(folder.path()).empty());
  EXPECT_TRUE(setBrokenAside(folder.path()).empty());
  EXPECT_TRUE(fs::exists(folder / ".8-8.host-8-0123.tmp.swaplight"));
}

TEST(KeptWork, ALockIsLockedFromTheMomentItCanBeSeen) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    for (int i = 0; i < 300; ++i) const RecoverySlot slot(folder.path());
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0)
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
      if (entry.path().extension() != ".lock") continue;
      const int handle = open(entry.path().c_str(), O_RDONLY | O_CLOEXEC);
      if (handle < 0) continue;  // it has gone meanwhile
      const bool taken = flock(handle, LOCK_EX | LOCK_NB) == 0;
      // Free only once it is gone from the folder: its process has cleaned up. Asked of the file, not of its
      // name, which the next slot of the same millisecond has again.
      struct stat found = {};
      ASSERT_EQ(fstat(handle, &found), 0);
      if (taken) {
        EXPECT_EQ(found.st_nlink, 0U);
      }
      close(handle);
    }
  EXPECT_EQ(status, 0);
}

TEST(KeptWork, TheSecondToSaveASessionIsToldOnce) {
  const TemporaryFolder folder;
  const fs::path file = folder / "a.swaplight";
  Session session;
  writeSession(session, file);
  writeSession(session, file);  // our own saving is no change
  Session opened = readSession(file);
  // Another studio, or an editor, saves.
  test::writeBytes(file, R"({"format": "swaplight-session", "version": 1, "source": "other.exr"})");
  EXPECT_THAT(test::inputError([&] { writeSession(opened, file); }),
              HasSubstr("was changed by another program"));
  EXPECT_THAT(test::readBytes(file), HasSubstr("other.exr"));
  writeSession(opened, folder / "b.swaplight");
  writeSession(opened, file);  // told, and wanted
  EXPECT_THAT(test::readBytes(file), testing::Not(HasSubstr("other.exr")));
}

TEST(KeptWork, ASessionThatWasDeletedMeanwhileIsSavedAgain) {
  const TemporaryFolder folder;
  writeSession(Session{}, folder / "a.swaplight");
  fs::remove(folder / "a.swaplight");
  writeSession(Session{}, folder / "a.swaplight");
  EXPECT_TRUE(fs::exists(folder / "a.swaplight"));
}

}  // namespace
}  // namespace swaplight
