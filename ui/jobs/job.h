#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/base/progress.h"

namespace swaplight {

/// Work in a thread of its own, with progress and cancel, for what would stop the interface. One at a time;
/// the result is taken by the thread that started it.
template <typename Result>
class Job {
 public:
  Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  ~Job() { stopAndWait(); }

  /// `work` runs in the thread; `done` is called from it at the end and at every progress, and may only wake
  /// somebody up. A job that is still running is stopped first.
  void start(std::function<Result(const Progress&)> work, std::function<void()> done) {
    stopAndWait();
    m_stop = false;
    m_finished = false;
    m_started = true;
    setProgress(0, "");
    m_thread = std::thread([this, work = std::move(work), done = std::move(done)] {
      Progress progress;
      progress.stop = &m_stop;
      progress.report = [this, &done](float fraction, std::string_view what) {
        if (setProgress(fraction, what)) done();
      };
      try {
        m_result = work(progress);
      } catch (...) {
        m_error = std::current_exception();
      }
      m_finished = true;
      done();
    });
  }

  /// Started, and its result not yet taken.
  [[nodiscard]] bool running() const { return m_started; }
  void cancel() { m_stop = true; }
  [[nodiscard]] bool cancelling() const { return m_stop; }

  [[nodiscard]] float fraction() const {
    const std::lock_guard lock(m_mutex);
    return m_fraction;
  }
  [[nodiscard]] std::string what() const {
    const std::lock_guard lock(m_mutex);
    return m_what;
  }

  /// The result once it is there. Throws what the work threw, Stopped where it was cancelled.
  std::optional<Result> take() {
    if (!m_started || !m_finished) return std::nullopt;
    m_thread.join();
    m_started = false;
    if (m_error) std::rethrow_exception(std::exchange(m_error, nullptr));
    return std::exchange(m_result, std::nullopt);
  }

 private:
  bool setProgress(float fraction, std::string_view what) {
    const std::lock_guard lock(m_mutex);
    const bool visible = fraction - m_fraction >= 0.01F || fraction < m_fraction || what != m_what;
    if (visible) {
      m_fraction = fraction;
      m_what = what;
    }
    return visible;
  }

  void stopAndWait() {
    m_stop = true;
    if (m_thread.joinable()) m_thread.join();
    m_started = false;
    m_result.reset();
    m_error = nullptr;
  }

  std::thread m_thread;
  std::atomic<bool> m_stop{false};
  std::atomic<bool> m_finished{false};
  bool m_started = false;
  mutable std::mutex m_mutex;
  float m_fraction = 0;
  std::string m_what;
  std::optional<Result> m_result;
  std::exception_ptr m_error;
};

}  // namespace swaplight
