#include "ui/jobs/messages.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <thread>

#include "ui/jobs/take_or_report.h"

namespace swaplight {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> shown(const Messages& messages) {
  std::vector<std::string> texts;
  for (const Messages::Message& message : messages.messages()) texts.push_back(message.text);
  return texts;
}

/// Runs a job to its end and takes what came of it.
Taken ended(Job<int>& job, Messages& messages, const std::function<int()>& work) {
  job.start([work](const Progress&) { return work(); }, [] {});
  Taken taken = Taken::Nothing;
  while (taken == Taken::Nothing) {
    taken = takeOrReport(job, messages, "this", [](int) {});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return taken;
}

int fails() {
  throw std::runtime_error("the disk is full");
}

TEST(Messages, WhatIsSaidAgainIsShownOnce) {
  Messages messages;
  messages.error("holds no photographs");
  messages.info("Saved");
  messages.error("holds no photographs");
  EXPECT_THAT(shown(messages), ElementsAre("Saved", "holds no photographs"));
}

TEST(Messages, ErrorsOfWhatWasOpenGoWithItAndTheOthersStay) {
  Messages messages;
  messages.errorThatStays("it crashed");
  messages.error("the file is gone");
  messages.warn("noisy");
  messages.forgetErrors();
  EXPECT_THAT(shown(messages), ElementsAre("it crashed", "noisy"));
}

TEST(Messages, AJobThatSucceedsTakesItsOwnErrorBack) {
  Messages messages;
  Job<int> job, other;
  EXPECT_EQ(ended(job, messages, fails), Taken::Failed);
  EXPECT_THAT(shown(messages), ElementsAre("the disk is full"));
  EXPECT_EQ(ended(other, messages, [] { return 1; }), Taken::Value);
  EXPECT_THAT(shown(messages), ElementsAre("the disk is full"));
  EXPECT_EQ(ended(job, messages, [] { return 1; }), Taken::Value);
  EXPECT_THAT(shown(messages), IsEmpty());
}

}  // namespace
}  // namespace swaplight
