#include "ui/window/hidden_contexts.h"

#include <GLFW/glfw3.h>

#include <utility>

#include "core/base/error.h"
#include "render/gl/gl_info.h"

namespace swaplight {
namespace {

GLFWwindow* hiddenWindow() {
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_MAXIMIZED, GLFW_FALSE);
  return glfwCreateWindow(1, 1, "hidden", nullptr, nullptr);
}

[[noreturn]] void failWithout() {
  throw ResourceError("the window's driver makes no OpenGL context beside it");
}

}  // namespace

/// Current on a thread until that gives it back.
class HiddenContexts::Leased : public GlContext {
 public:
  Leased(std::shared_ptr<Pool> pool, GLFWwindow* window) : m_pool(std::move(pool)), m_window(window) {
    glfwMakeContextCurrent(m_window);
    if (glfwGetCurrentContext() != m_window) failWithout();
    installGlDebugOutput();
  }
  ~Leased() override {
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
    pool->changed.wait(lock, [&] { return !pool->free.empty() || pool->ended; });
    --pool->waiting;
    if (pool->free.empty()) failWithout();
    GLFWwindow* window = pool->free.back();
    pool->free.pop_back();
    lock.unlock();
    return std::make_unique<Leased>(pool, window);
  });
}

HiddenContexts::~HiddenContexts() {
  setGlContextSource({});
  close();
}

void HiddenContexts::createRequested() {
  std::unique_lock lock(m_pool->mutex);
  while (!m_pool->ended && m_pool->free.size() < m_pool->waiting) {
    lock.unlock();
    GLFWwindow* window = hiddenWindow();
    lock.lock();
    if (window)
      m_pool->free.push_back(window);
    else
      m_pool->ended = true;
    m_pool->changed.notify_all();
  }
}

void HiddenContexts::close() {
  const std::lock_guard lock(m_pool->mutex);
  m_pool->ended = true;
  m_pool->changed.notify_all();
}

}  // namespace swaplight
