#include "core/diagnosis/crash_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

#ifndef SWAPLIGHT_SANITIZE

/// The only report in the folder.
std::string reportIn(const std::filesystem::path& folder) {
  std::ostringstream text;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    text << std::ifstream(entry.path()).rdbuf();
  return text.str();
}

[[gnu::noinline]] int deep(int depth) {
  volatile char room[4096] = {};
  return depth == 0 ? 0 : deep(depth - 1) + room[depth % 4096];
}

TEST(CrashReport, TellsTheSignalTheFactsAndThePlace) {
  const test::TemporaryFolder folder;
  EXPECT_EXIT(
      {
        setCrashFact("graphics", "one");
        setCrashFact("graphics", "another");
        reportCrashes(folder.path(), STDERR_FILENO);
        std::raise(SIGSEGV);
      },
      testing::KilledBySignal(SIGSEGV), "crashed. What its makers want to know stands in .*crash-");
  const std::string report = reportIn(folder.path());
  EXPECT_THAT(report, testing::HasSubstr("SIGSEGV"));
  EXPECT_THAT(report, testing::HasSubstr("graphics: another\n"));
  EXPECT_THAT(report, testing::Not(testing::HasSubstr("graphics: one")));
  EXPECT_THAT(report, testing::HasSubstr("diagnosis_tests"));
}

TEST(CrashReport, TellsAnExceptionThatNobodyCaught) {
  const test::TemporaryFolder folder;
  EXPECT_EXIT(
      {
        reportCrashes(folder.path(), STDERR_FILENO);
        std::thread([] { throw std::runtime_error("what nobody caught"); }).join();
      },
      testing::KilledBySignal(SIGABRT), "crashed");
  EXPECT_THAT(reportIn(folder.path()), testing::HasSubstr("exception: what nobody caught"));
}

TEST(CrashReport, WorksOnAStackThatIsFull) {
  const test::TemporaryFolder folder;
  EXPECT_EXIT(
      {
        reportCrashes(folder.path(), STDERR_FILENO);
        std::exit(deep(1 << 24));
      },
      testing::KilledBySignal(SIGSEGV), "crashed");
  EXPECT_THAT(reportIn(folder.path()), testing::HasSubstr("SIGSEGV"));
}

#endif

TEST(CrashReport, IsShownOnce) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(unseenCrash(folder.path()), std::nullopt);
  EXPECT_EQ(unseenCrash(folder / "missing"), std::nullopt);
  std::ofstream(folder / "crash-1.txt") << "first";
  EXPECT_EQ(unseenCrash(folder.path()), folder / "crash-1.txt");
  EXPECT_EQ(unseenCrash(folder.path()), std::nullopt);
  std::ofstream(folder / "crash-2.txt") << "second";
  const auto later = std::filesystem::last_write_time(folder / "crash-1.txt") + std::chrono::seconds(2);
  std::filesystem::last_write_time(folder / "crash-2.txt", later);
  EXPECT_EQ(unseenCrash(folder.path()), folder / "crash-2.txt");
  EXPECT_EQ(unseenCrash(folder.path()), std::nullopt);
}

}  // namespace
}  // namespace swaplight
