#include "ui/window/hidden_contexts.h"

#include <GLFW/glfw3.h>

#include <chrono>
#include <utility>

#include "core/base/error.h"

namespace swaplight {
namespace {

/// The window answers between two frames; while it closes it does not.
constexpr std::chrono::seconds kMostWait{10};

GLFWwindow* hiddenWindow() {
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_MAXIMIZED, GLFW_FALSE);
  return glfwCreateWindow(1, 1, "hidden", nullptr, nullptr);
}

}  // namespace

/// Current on a thread until that gives it back.
class HiddenContexts::Lent : public GlContext {
 public:
  Lent(std::shared_ptr<Pool> pool, GLFWwindow* window) : m_pool(std::move(pool)), m_window(window) {
    glfwMakeContextCurrent(m_window);
  }
  ~Lent() override {
    glfwMakeContextCurrent(nullptr);
    const std::lock_guard lock(m_pool->mutex);
    m_pool->free.push_back(m_window);
    m_pool->changed.notify_one();
  }

 private:
  std::shared_ptr<Pool> m_pool;
  GLFWwindow* m_window;
};

HiddenContexts::HiddenContexts() {
  setGlContextSource([pool = m_pool]() -> std::unique_ptr<GlContext> {
    std::unique_lock lock(pool->mutex);
    ++pool->waiting;
    glfwPostEmptyEvent();
    pool->changed.wait_for(lock, kMostWait, [&] { return !pool->free.empty() || pool->failed; });
    --pool->waiting;
    if (pool->free.empty()) throw ResourceError("the window's driver makes no OpenGL context beside it");
    GLFWwindow* window = pool->free.back();
    pool->free.pop_back();
    lock.unlock();
    return std::make_unique<Lent>(pool, window);
  });
}

HiddenContexts::~HiddenContexts() {
  setGlContextSource({});
}

void HiddenContexts::prepare(bool idle) {
  std::unique_lock lock(m_pool->mutex);
  const size_t wanted = m_pool->waiting + (idle ? 1 : 0);
  while (!m_pool->failed && m_pool->free.size() < wanted) {
    lock.unlock();
    GLFWwindow* window = hiddenWindow();
    lock.lock();
    if (window)
      m_pool->free.push_back(window);
    else
      m_pool->failed = true;
    m_pool->changed.notify_all();
  }
}

}  // namespace swaplight
