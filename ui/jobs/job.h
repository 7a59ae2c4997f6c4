#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/progress.h"

namespace swaplight {

/// Work in a thread of its own, with progress and cancel, for what would stop the interface. Of one job the
/// last work counts; the result is taken by the thread that started it. Nothing but the destructor and
/// endsWithin() waits for a thread.
template <typename Result>
class Job {
 public:
  Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  /// Stops what is running and waits for it: what the work and `done` refer to must outlive the job.
  ~Job() {
    drop();
    for (Thread& old : m_dropped) old.thread.join();
  }

  /// `work` runs in the thread; `done` is called from it at the end, at new words, and for a
  /// new fraction alone five times a second at most. It may only wake somebody up. Work that is still going
  /// on is told to stop and ends when it notices; nobody hears of its result, nor of what went wrong in it.
  /// Until then both may be running.
  void start(std::function<Result(const Progress&)> work, std::function<void()> done) {
    drop();
    auto run = std::make_shared<Run>();
    std::thread thread([run, work = std::move(work), done = std::move(done)]() mutable {
      run->execute(std::exchange(work, nullptr), done);
    });
    m_last = {std::move(thread), std::move(run)};
  }

  /// Started, and its result not yet taken.
  [[nodiscard]] bool running() const { return m_last.run != nullptr; }
  void cancel() {
    if (running()) m_last.run->stop = true;
  }
  /// The last work counts no more: it is told to stop, and nobody hears of its result, not even of one that
  /// is there already.
  void drop() {
    if (running()) {
      m_last.run->dropped = true;
      m_last.run->stop = true;
      m_dropped.push_back(std::exchange(m_last, {}));
    }
    forgetEnded();
  }
  /// Told to stop, and still running.
  [[nodiscard]] bool cancelling() const { return running() && m_last.run->stop; }

  /// 0..1; 0 where nothing is running.
  [[nodiscard]] float fraction() const {
    if (!running()) return 0;
    const std::lock_guard lock(m_last.run->mutex);
    return m_last.run->fraction;
  }
  /// What it is doing, in words.
  [[nodiscard]] std::string what() const {
    if (!running()) return {};
    const std::lock_guard lock(m_last.run->mutex);
    return m_last.run->what;
  }

  /// Waits until the work has ended, but no longer than this: whether it has. For work that takes less than a
  /// frame.
  bool endsWithin(std::chrono::nanoseconds time) {
    if (!running()) return false;
    Run& run = *m_last.run;
    std::unique_lock lock(run.mutex);
    return run.ended.wait_for(lock, time, [&run] { return run.finished.load(); });
  }

  /// The result once it is there. Throws what the work threw, Stopped where it was cancelled in time.
  std::optional<Result> take() {
    forgetEnded();
    if (!running() || !m_last.run->finished) return std::nullopt;
    const Thread last = join(std::exchange(m_last, {}));
    if (last.run->error) std::rethrow_exception(last.run->error);
    return std::move(last.run->result);
  }

 private:
  /// What a thread shares with who started it. It belongs to both: a thread that nobody waits for has a place
  /// for its result all the same.
  struct Run {
    std::atomic<bool> stop{false};
    std::atomic<bool> dropped{false};  ///< nobody wants the result
    std::atomic<bool> finished{false};
    std::condition_variable ended;
    std::mutex mutex;  ///< of the next two, and of waiting for the end
    float fraction = 0;
    std::string what;
    std::optional<Result> result;  ///< until `finished` the thread's, then the owner's
    std::exception_ptr error;

    void execute(std::function<Result(const Progress&)> work, const std::function<void()>& done) {
      Progress progress;
      progress.stop = &stop;
      progress.report = [&](float part, std::string_view words) {
        if (set(part, words) && !dropped) done();
      };
      try {
        result = work(progress);
      } catch (...) {
        error = std::current_exception();
      }
      work = nullptr;  // what it holds goes before somebody hears of the result
      {
        const std::lock_guard lock(mutex);
        finished = true;
      }
      ended.notify_all();
      if (!dropped) done();
    }

   private:
    using Clock = std::chrono::steady_clock;
    /// Frames that only show a bar move take time from the work.
    static constexpr std::chrono::milliseconds kBarMoves{200};
    Clock::time_point m_told;  ///< of the thread alone

    /// Whether somebody should look.
    bool set(float part, std::string_view words) {
      const std::lock_guard lock(mutex);
      const bool changed = part != fraction, said = words != what;
      fraction = part;
      what = words;
      const Clock::time_point now = Clock::now();
      if (!said && (!changed || now - m_told < kBarMoves)) return false;
      m_told = now;
      return true;
    }
  };
  struct Thread {
    std::thread thread;
    std::shared_ptr<Run> run;
  };

  static Thread join(Thread thread) {
    thread.thread.join();
    return thread;
  }

  /// Threads that have come to their end are joined without waiting.
  void forgetEnded() {
    const auto ended = std::partition(m_dropped.begin(), m_dropped.end(),
                                      [](const Thread& old) { return !old.run->finished; });
    std::for_each(ended, m_dropped.end(), [](Thread& old) { old.thread.join(); });
    m_dropped.erase(ended, m_dropped.end());
  }

  Thread m_last;
  std::vector<Thread> m_dropped;  ///< not yet ended
};

}  // namespace swaplight
