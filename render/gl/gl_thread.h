#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

namespace swaplight {

/// A thread with an OpenGL context of its own, without a window: for those who draw from threads of their
/// own, or beside a window's context. What is made there has to be destroyed there.
class GlThread {
 public:
  /// Throws ResourceError that says what OpenGL lacks here.
  GlThread();
  GlThread(const GlThread&) = delete;
  GlThread& operator=(const GlThread&) = delete;
  /// After all work that was given to it.
  ~GlThread();

  /// Does the work there, after what was asked for before, and waits for it: its result, or what it throws.
  template <typename Work>
  auto run(Work work) -> decltype(work()) {
    std::packaged_task<decltype(work())()> task(std::move(work));
    auto result = task.get_future();
    enqueue([&task] { task(); });
    return result.get();
  }

 private:
  void enqueue(std::function<void()> task);
  void loop(std::promise<void> ready);

  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::deque<std::function<void()>> m_tasks;
  bool m_end = false;
  std::thread m_thread;
};

}  // namespace swaplight
