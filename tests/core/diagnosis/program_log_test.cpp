#include "core/diagnosis/program_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(ProgramLog, LinesOfManyThreadsAreWhole) {
  const test::TemporaryFolder folder;
  openProgramLog(folder.path());
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([] {
      for (int k = 0; k < 100; ++k) logLine("forty letters, so that they can be told");
    });
  for (std::thread& thread : threads) thread.join();
  std::ifstream in(folder / "swaplight.log");
  int lines = 0;
  for (std::string line; std::getline(in, line); ++lines)
    EXPECT_TRUE(line.ends_with(" forty letters, so that they can be told")) << line;
  EXPECT_EQ(lines, 400);
}

TEST(ProgramLog, AMessageCannotMakeALineOfItsOwn) {
  const test::TemporaryFolder folder;
  openProgramLog(folder.path());
  logLine("one\nerror: another\x1b[2J");
  const std::string text = textOf(folder / "swaplight.log");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST(ProgramLog, TurnsOverAboveAMebibyteAndKeepsTwo) {
  const test::TemporaryFolder folder;
  for (const char letter : {'a', 'b', 'c', 'd'}) {
    openProgramLog(folder.path());
    for (int i = 0; i < 400; ++i) logLine(std::string(3000, letter));
  }
  EXPECT_THAT(textOf(folder / "swaplight.log"), testing::HasSubstr("ddd"));
  EXPECT_THAT(textOf(folder / "swaplight.1.log"), testing::HasSubstr("ccc"));
  EXPECT_THAT(textOf(folder / "swaplight.2.log"), testing::HasSubstr("bbb"));
  EXPECT_EQ(folder.fileCount(), 3U);
}

TEST(ProgramLog, AFolderThatCannotBeWrittenIsNoError) {
  openProgramLog("/proc/nowhere");
  logLine("nobody hears this");
}

}  // namespace
}  // namespace swaplight
