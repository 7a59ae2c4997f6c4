#include "ui/jobs/job.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <new>
#include <stdexcept>

#include "ui/jobs/take_or_report.h"

namespace swaplight {
namespace {

using namespace std::chrono_literals;

/// A gate that a thread waits at.
struct Gate {
  std::promise<void> promise;
  std::shared_future<void> opened = promise.get_future().share();
  void open() { promise.set_value(); }
};

/// Takes until there is something; fails the test after a minute.
template <typename Result>
std::optional<Result> taken(Job<Result>& job) {
  const auto patience = std::chrono::steady_clock::now() + 60s;
  while (std::chrono::steady_clock::now() < patience) {
    if (auto result = job.take()) return result;
    std::this_thread::sleep_for(1ms);
  }
  ADD_FAILURE() << "nothing came";
  return std::nullopt;
}

/// Waits as long as nobody asks it to stop.
int untilStopped(const Progress& progress) {
  for (;;) {
    progress.update(0.5F, "waiting");
    std::this_thread::sleep_for(1ms);
  }
}

TEST(Job, GivesItsResultOnce) {
  Job<std::string> job;
  EXPECT_FALSE(job.running());
  EXPECT_FALSE(job.take());
  job.start([](const Progress&) { return std::string("done"); }, [] {});
  EXPECT_TRUE(job.running());
  EXPECT_EQ(taken(job), "done");
  EXPECT_FALSE(job.running());
  EXPECT_FALSE(job.take());
}

TEST(Job, IsWaitedForNoLongerThanToldTo) {
  Gate gate;
  Job<int> job;
  EXPECT_FALSE(job.endsWithin(1ms)) << "nothing runs";
  job.start([opened = gate.opened](const Progress&) { return opened.wait(), 1; }, [] {});
  EXPECT_FALSE(job.endsWithin(1ms));
  gate.open();
  EXPECT_TRUE(job.endsWithin(60s));
  EXPECT_EQ(job.take(), 1);
}

TEST(Job, ThrowsWhatItsWorkThrewAndCanStartAgain) {
  Job<int> job;
  job.start([](const Progress&) -> int { throw std::runtime_error("broken"); }, [] {});
  EXPECT_THROW(taken(job), std::runtime_error);
  EXPECT_FALSE(job.running());
  job.start([](const Progress&) { return 7; }, [] {});
  EXPECT_EQ(taken(job), 7);
}

TEST(Job, TellsHowFarItIsAndWakesTheInterface) {
  Job<int> job;
  Gate half;
  Gate go;
  std::atomic<int> woken{0};
  job.start(
      [&](const Progress& progress) {
        progress.update(0.5F, "half");
        half.open();
        go.opened.wait();
        return 1;
      },
      [&] { ++woken; });
  half.opened.wait();
  EXPECT_FLOAT_EQ(job.fraction(), 0.5F);
  EXPECT_EQ(job.what(), "half");
  EXPECT_GE(woken, 1);
  EXPECT_FALSE(job.take()) << "it is not there yet";
  go.open();
  EXPECT_EQ(taken(job), 1);
  EXPECT_GE(woken, 2) << "the result is news, too";
  EXPECT_EQ(job.fraction(), 0);
  EXPECT_EQ(job.what(), "");
}

TEST(Job, WakesAtNewWordsAndLeavesTheBarToATimer) {
  constexpr int kSteps = 1000;
  Job<int> job;
  std::atomic<int> woken{0};
  Gate counted;
  Gate go;
  const auto begin = std::chrono::steady_clock::now();
  job.start(
      [&](const Progress& progress) {
        for (int k = 1; k <= kSteps; ++k) progress.update(static_cast<float>(k) / kSteps, "solving");
        counted.open();
        go.opened.wait();
        progress.update(1, "finding shadows");
        return 1;
      },
      [&] { ++woken; });
  counted.opened.wait();
  EXPECT_EQ(job.fraction(), 1) << "whoever looks sees how far it is";
  go.open();
  EXPECT_TRUE(taken(job));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(woken, 3) << "twice for what it says, once for the end";
  EXPECT_LE(woken, 4 + static_cast<int>(took.count() / .2));
}

TEST(Job, IsCancellingOnlyWhileItRuns) {
  Job<int> job;
  job.cancel();
  EXPECT_FALSE(job.cancelling()) << "there is nothing to cancel";
  job.start(untilStopped, [] {});
  EXPECT_FALSE(job.cancelling());
  job.cancel();
  EXPECT_TRUE(job.cancelling());
  EXPECT_THROW(taken(job), Stopped);
  EXPECT_FALSE(job.cancelling());
  EXPECT_FALSE(job.running());
}

TEST(Job, StartingAgainDoesNotWaitForWorkThatDoesNotListen) {
  Gate deaf;
  std::atomic<bool> ended{false};
  std::atomic<int> wokenByOld{0};
  {
    Job<int> job;
    Gate begun;
    job.start(
        [&](const Progress&) {
          begun.open();
          deaf.opened.wait();  // does not look whether it should stop
          ended = true;
          return 1;
        },
        [&] { ++wokenByOld; });
    begun.opened.wait();
    job.start([](const Progress&) { return 2; }, [] {});
    EXPECT_FALSE(ended) << "start waited for the old thread";
    EXPECT_EQ(taken(job), 2);
    EXPECT_FALSE(ended);
    deaf.open();
    job.start([](const Progress&) { return 3; }, [] {});
    EXPECT_EQ(taken(job), 3) << "the old result does not come in between";
  }
  EXPECT_TRUE(ended) << "the destructor waits for every thread";
  EXPECT_EQ(wokenByOld, 0) << "nobody hears of work that was dropped";
}

TEST(Job, WorkThatWasReplacedIsToldToStopAndItsErrorIsDropped) {
  Job<int> job;
  Gate begun;
  std::atomic<bool> stopped{false};
  job.start(
      [&](const Progress& progress) -> int {
        begun.open();
        try {
          return untilStopped(progress);
        } catch (const Stopped&) {
          stopped = true;
          throw;
        }
      },
      [] {});
  begun.opened.wait();
  job.start([](const Progress&) { return 2; }, [] {});
  EXPECT_EQ(taken(job), 2);
  while (!stopped) std::this_thread::sleep_for(1ms);
  EXPECT_FALSE(job.take());
}

TEST(Job, WhatTheWorkHoldsGoesBeforeTheResultIsThere) {
  Job<int> job;
  auto held = std::make_shared<int>(1);
  const std::weak_ptr<int> watched = held;
  job.start([held = std::move(held)](const Progress&) { return *held; }, [] {});
  EXPECT_EQ(taken(job), 1);
  EXPECT_TRUE(watched.expired());
}

TEST(Job, ManyInARowLeaveTheLastResult) {
  Job<int> job;
  std::atomic<int> going{0};
  for (int i = 0; i < 200; ++i)
    job.start(
        [i, &going](const Progress& progress) {
          ++going;
          for (int k = 0; k < 5; ++k) progress.update(static_cast<float>(k) / 5, "counting");
          --going;
          return i;
        },
        [] {});
  EXPECT_EQ(taken(job), 199);
}

// What takeOrReport makes of a job's end.

TEST(TakeOrReport, HandsTheValueOnOnce) {
  Job<int> job;
  Messages messages;
  int got = 0;
  const auto take = [&] { return takeOrReport(job, messages, "this", [&](int value) { got = value; }); };
  EXPECT_EQ(take(), Taken::Nothing);
  job.start([](const Progress&) { return 5; }, [] {});
  Taken last = Taken::Nothing;
  while ((last = take()) == Taken::Nothing) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(last, Taken::Value);
  EXPECT_EQ(got, 5);
  EXPECT_EQ(take(), Taken::Nothing);
  EXPECT_TRUE(messages.messages().empty());
}

Taken endOf(Job<int>& job, Messages& messages) {
  Taken last = Taken::Nothing;
  while ((last = takeOrReport(job, messages, "this export",
                              [](int) { throw InputError("no place for it"); })) == Taken::Nothing)
    std::this_thread::sleep_for(1ms);
  return last;
}

TEST(TakeOrReport, SaysWhatWentWrong) {
  Job<int> job;
  Messages messages;
  job.start([](const Progress&) -> int { throw InputError("a.exr: no such file"); }, [] {});
  EXPECT_EQ(endOf(job, messages), Taken::Failed);
  job.start([](const Progress&) -> int { throw std::bad_alloc(); }, [] {});
  EXPECT_EQ(endOf(job, messages), Taken::Failed);
  job.start([](const Progress&) { return 1; }, [] {});
  EXPECT_EQ(endOf(job, messages), Taken::Failed) << "what goes wrong with the value counts as well";
  ASSERT_EQ(messages.messages().size(), 3U);
  EXPECT_EQ(messages.messages()[0].text, "a.exr: no such file");
  EXPECT_EQ(messages.messages()[1].text, "There is not enough memory for this export.");
  EXPECT_EQ(messages.messages()[2].text, "no place for it");
}

TEST(TakeOrReport, IsSilentWhereThePersonCancelled) {
  Job<int> job;
  Messages messages;
  job.start(untilStopped, [] {});
  job.cancel();
  EXPECT_EQ(endOf(job, messages), Taken::Stopped);
  EXPECT_TRUE(messages.messages().empty());
}

}  // namespace
}  // namespace swaplight
