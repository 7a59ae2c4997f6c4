#include "render/gl/gl_thread.h"

#include <exception>
#include <memory>
#include <system_error>

#include "core/base/error.h"
#include "render/gl/gl_context.h"

namespace swaplight {

GlThread::GlThread() {
  std::promise<void> ready;
  std::future<void> isReady = ready.get_future();
  try {
    m_thread = std::thread([this, ready = std::move(ready)]() mutable { loop(std::move(ready)); });
  } catch (const std::system_error&) {
    throw ResourceError("no thread is left to draw in");
  }
  try {
    isReady.get();
  } catch (...) {
    m_thread.join();
    throw;
  }
}

GlThread::~GlThread() {
  {
    const std::lock_guard lock(m_mutex);
    m_end = true;
  }
  m_changed.notify_one();
  m_thread.join();
}

void GlThread::enqueue(std::function<void()> task) {
  {
    const std::lock_guard lock(m_mutex);
    m_tasks.push_back(std::move(task));
  }
  m_changed.notify_one();
}

void GlThread::loop(std::promise<void> ready) {
  std::unique_ptr<GlContext> context;
  try {
    context = newGlContext();
  } catch (...) {
    ready.set_exception(std::current_exception());
    return;
  }
  ready.set_value();
  std::unique_lock lock(m_mutex);
  while (true) {
    m_changed.wait(lock, [this] { return m_end || !m_tasks.empty(); });
    if (m_tasks.empty()) return;
    const std::function<void()> task = std::move(m_tasks.front());
    m_tasks.pop_front();
    lock.unlock();
    task();
    lock.lock();
  }
}

}  // namespace swaplight
