#include "core/sandbox/helper_processes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/sandbox/shared_memory.h"

#ifndef SWAPLIGHT_SANITIZE  // its limits are not for the sanitizers

namespace swaplight {
namespace {

// What a process that a picture has taken over might try. Each gives the errno of what it tried, 0: it could.
int errorOf(long result) {
  return result < 0 ? errno : 0;
}

const std::map<std::string, std::function<int()>> kTries = {
    {"write", [] { return errorOf(::open("/tmp/swaplight-escape", O_WRONLY | O_CREAT, 0600)); }},
    {"truncate", [] { return errorOf(::truncate("/tmp/swaplight-escape", 0)); }},
    {"remove", [] { return errorOf(::unlink("/tmp/swaplight-escape")); }},
    {"rename", [] { return errorOf(::rename("/tmp/swaplight-escape", "/tmp/swaplight-escaped")); }},
    {"socket", [] { return errorOf(::socket(AF_INET, SOCK_STREAM, 0)); }},
    {"fork", [] { return errorOf(::fork()); }},
    {"exec",
     [] {
       char name[] = "/bin/true";
       char* arguments[] = {name, nullptr};
       return errorOf(::execv(name, arguments));
     }},
    {"kill", [] { return errorOf(::kill(::getppid(), SIGTERM)); }},
    {"code",
     [] {
       void* page =
           ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
       return page == MAP_FAILED ? errno : 0;
     }},
    {"read", [] { return errorOf(::open("/proc/self/status", O_RDONLY)); }},
    {"threads",
     [] {
       int sum = 0;
       std::thread([&] { sum = 1; }).join();
       return sum - 1;
     }},
    {"memory",
     [] {
       const std::unique_ptr<char[]> much(new (std::nothrow) char[size_t{3} << 30]);
       return much ? 0 : ENOMEM;
     }},
    {"crash", []() -> int { std::abort(); }},
    {"endless",
     [] {
       volatile bool always = true;
       while (always) {
       }
       return 0;
     }},
};

void tryIt(const Channel& channel) {
  while (const auto what = channel.receive(100)) {
    const int error = kTries.at(*what)();
    if (!channel.send(std::to_string(error))) return;
  }
}

// Before there are threads: gtest runs all tests of a program in one process.
const HelperProcesses g_helpers({[] {}, tryIt, {size_t{1} << 30, 2}});

/// The errno of a try; nothing where the process died of it.
std::optional<int> tried(const std::string& what) {
  const Channel channel = g_helpers.start();
  EXPECT_TRUE(channel.send(what));
  const auto answer = channel.receive(100);
  return answer ? std::optional<int>(std::stoi(*answer)) : std::nullopt;
}

TEST(HelperProcesses, ReadAndComputeAndNothingElse) {
  EXPECT_EQ(tried("read"), 0);
  EXPECT_EQ(tried("threads"), 0);
#ifdef __linux__
  for (const char* what : {"write", "truncate", "remove", "rename", "socket", "fork", "exec", "kill", "code"})
    EXPECT_EQ(tried(what), EPERM) << what;
#endif
}

TEST(HelperProcesses, HaveBoundedMemoryAndTime) {
  EXPECT_EQ(tried("memory"), ENOMEM);
  EXPECT_EQ(tried("endless"), std::nullopt);
}

TEST(HelperProcesses, OneThatCrashesHarmsNoOther) {
  const Channel other = g_helpers.start();
  EXPECT_EQ(tried("crash"), std::nullopt);
  EXPECT_TRUE(other.send("read"));
  EXPECT_EQ(other.receive(100), "0");
  EXPECT_EQ(tried("read"), 0);
}

TEST(HelperProcesses, ManyAtOnceFromManyThreads) {
  std::vector<std::thread> threads;
  std::atomic<int> read{0};
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 5; ++k) read += tried("read") == 0;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(read, 40);
}

TEST(Channel, RefusesWhatIsLongerThanExpected) {
  const auto [one, other] = Channel::pair();
  EXPECT_TRUE(one.send("twelve bytes"));
  EXPECT_EQ(other.receive(5), std::nullopt);
}

TEST(SharedMemory, CannotBeCutUnderTheOthersEyes) {
  const SharedMemory memory(1 << 16);
  memory.data()[0] = std::byte{1};
#ifdef __linux__
  EXPECT_NE(::ftruncate(memory.descriptor(), 0), 0);
#endif
}

}  // namespace
}  // namespace swaplight

#endif
