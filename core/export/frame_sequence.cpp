#include "core/export/frame_sequence.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "core/base/error.h"
#include "core/base/machine_error.h"
#include "core/file/frame_range.h"
#include "core/file/same_file.h"

namespace swaplight {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The workers of a sequence and what they share.
class SequenceRun {
 public:
  SequenceRun(const ColorConfig& config, const SequenceOptions& options,
              const std::function<FrameInput(int)>& input,
              const std::function<void(const FrameOutcome&)>& done, const Progress& progress)
      : m_config(config),
        m_options(options),
        m_input(input),
        m_done(done),
        m_progress(progress),
        m_outcomes(options.frames.size()) {}

  SequenceSummary run() {
    const auto started = Clock::now();
    const int workers = std::clamp(m_options.workers, 1, std::max(1, static_cast<int>(m_outcomes.size())));
    std::vector<std::jthread> threads;
    try {
      for (int i = 1; i < workers; ++i) threads.emplace_back([this] { work(); });
    } catch (const std::system_error&) {  // no thread is left: fewer workers make the same frames
    }
    work();
    threads.clear();  // waits for them
    if (m_thrown) std::rethrow_exception(m_thrown);
    SequenceSummary summary;
    for (std::optional<FrameOutcome>& outcome : m_outcomes)
      if (outcome) summary.outcomes.push_back(std::move(*outcome));
    summary.seconds = secondsSince(started);
    const double all = std::max(1e-9, m_workSeconds);
    summary.inputShare = m_inputSeconds / all;
    summary.writeShare = m_writeSeconds / all;
    return summary;
  }

 private:
  void work() {
    for (size_t i = m_next++; i < m_outcomes.size() && !m_end; i = m_next++) {
      try {
        finish(i, make(m_options.frames[i]));
      } catch (...) {  // stopped, or out of memory: nothing that another frame would survive
        const std::lock_guard lock(m_mutex);
        if (!m_thrown) m_thrown = std::current_exception();
        m_end = true;
      }
    }
  }

  FrameOutcome make(int frame) {
    FrameOutcome outcome{frame, frameName(m_options.output, frame), FrameOutcome::State::Written, {}};
    if (m_options.skipExisting && std::filesystem::exists(outcome.file)) {
      outcome.state = FrameOutcome::State::Skipped;
      return outcome;
    }
    try {
      write(frame, outcome.file);
    } catch (const InputError& error) {
      outcome.state = FrameOutcome::State::Failed;
      outcome.error = error.what();
      outcome.machine = dynamic_cast<const MachineError*>(&error) != nullptr;
    }
    return outcome;
  }

  void write(int frame, const std::filesystem::path& file) {
    const auto started = Clock::now();
    const FrameInput input = m_input(frame);
    const double read = secondsSince(started);
    FrameOptions options = m_options.frame;
    options.write.text = input.text;
    options.write.carried = input.carried;
    options.frameNumber = frame;
    auto writing = started;
    Progress progress;
    progress.stop = m_progress.stop;
    progress.report = [&](float, std::string_view what) {
      if (what == "writing" && writing == started) writing = Clock::now();
    };
    exportFrame(m_config, *input.set, input.rig, file, options, progress);
    const std::lock_guard lock(m_mutex);
    m_inputSeconds += read;
    m_writeSeconds += secondsSince(writing);
    m_workSeconds += secondsSince(started);
  }

  void finish(size_t index, FrameOutcome outcome) {
    const std::lock_guard lock(m_mutex);
    m_done(outcome);
    if (outcome.state == FrameOutcome::State::Failed && !m_options.goOn) m_end = true;
    m_outcomes[index] = std::move(outcome);
    m_progress.update(static_cast<float>(++m_finished) / static_cast<float>(m_outcomes.size()), "frames");
  }

  const ColorConfig& m_config;
  const SequenceOptions& m_options;
  const std::function<FrameInput(int)>& m_input;
  const std::function<void(const FrameOutcome&)>& m_done;
  const Progress& m_progress;
  std::vector<std::optional<FrameOutcome>> m_outcomes;
  std::atomic<size_t> m_next = 0;
  std::atomic<bool> m_end = false;
  std::mutex m_mutex;
  size_t m_finished = 0;
  double m_inputSeconds = 0, m_writeSeconds = 0, m_workSeconds = 0;
  std::exception_ptr m_thrown;
};

}  // namespace

int SequenceSummary::count(FrameOutcome::State state) const {
  return static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(),
                                        [&](const FrameOutcome& outcome) { return outcome.state == state; }));
}

void checkFrameFiles(const std::string& output, std::span<const int> frames,
                     std::span<const std::filesystem::path> inputs) {
  std::error_code error;
  for (const int frame : frames)
    if (std::filesystem::exists(frameName(output, frame), error) || frame == frames.front())
      checkOutput(frameName(output, frame), inputs);
}

SequenceSummary exportSequence(const ColorConfig& config, const SequenceOptions& options,
                               const std::function<FrameInput(int)>& input,
                               const std::function<void(const FrameOutcome&)>& done,
                               const Progress& progress) {
  return SequenceRun(config, options, input, done, progress).run();
}

}  // namespace swaplight
