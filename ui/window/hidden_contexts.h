#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "render/gl/gl_context.h"

struct GLFWwindow;

namespace swaplight {

/// OpenGL contexts for threads that draw beside a window, from the window's own driver: those of windows that
/// are never shown. As long as it lives it is where GlThread gets them from. GLFW makes windows only on the
/// thread that it was started on, so a thread that finds none free waits for createRequested() there, or for
/// close().
class HiddenContexts {
 public:
  HiddenContexts();
  HiddenContexts(const HiddenContexts&) = delete;
  HiddenContexts& operator=(const HiddenContexts&) = delete;
  /// No thread may draw any more. The hidden windows end with GLFW.
  ~HiddenContexts();

  /// Often, on GLFW's thread: makes what is being waited for.
  void createRequested();
  /// There will be no createRequested() any more: who waits, and who asks from now on, gets a ResourceError.
  void close();

 private:
  class Leased;
  /// What threads share with it.
  struct Pool {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<GLFWwindow*> free;
    size_t waiting = 0;
    bool ended = false;  ///< there will be no more of them
  };

  std::shared_ptr<Pool> m_pool = std::make_shared<Pool>();
};

}  // namespace swaplight
