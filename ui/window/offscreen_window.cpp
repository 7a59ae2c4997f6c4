#include <imgui.h>
#include <imgui/backends/imgui_impl_opengl3.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "render/gl/egl_context.h"
#include "render/surface.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/tooltip_clock.h"
#include "ui/window/window.h"

namespace swaplight {
namespace {

class OffscreenWindow : public Window {
 public:
  OffscreenWindow(int width, int height) : m_width(width), m_height(height), m_target(width, height) {
    ImGui_ImplOpenGL3_Init("#version 410 core");
    int* keys = ImGui::GetIO().KeyMap;
    for (int key = 0; key < ImGuiKey_COUNT; ++key) keys[key] = key;
  }
  ~OffscreenWindow() override { ImGui_ImplOpenGL3_Shutdown(); }

  void wait(double seconds) override {
    std::unique_lock lock(m_mutex);
    if (!frameWanted())
      m_wakeUp.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return m_woken; });
    if (std::exchange(m_woken, false)) requestFrames();
  }
  void wake() override {
    const std::lock_guard lock(m_mutex);
    m_woken = true;
    m_wakeUp.notify_one();
  }

  void beginFrame() override {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(m_width), static_cast<float>(m_height));
    io.DeltaTime = 1.0F / 60;
    ImGui_ImplOpenGL3_NewFrame();
    applyPretendedMouse();
    mannersBeforeFrame();
    ImGui::NewFrame();
    mannersFrame();
    tooltipClockFrame();
  }

  void endFrame() override {
    ImGui::Render();
    m_target.bind();
    clearSurface(m_width, m_height, backgroundCode());
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    frameDone();
  }

  [[nodiscard]] int width() const override { return m_width; }
  [[nodiscard]] int height() const override { return m_height; }
  [[nodiscard]] Pixels pixels() override {
    m_target.bind();
    return {m_width, m_height, readSurface(m_width, m_height)};
  }

 private:
  int m_width, m_height;
  EglContext m_context;
  SurfaceTarget m_target;
  std::mutex m_mutex;
  std::condition_variable m_wakeUp;
  bool m_woken = false;
};

}  // namespace

std::unique_ptr<Window> openOffscreen(int width, int height) {
  return std::make_unique<OffscreenWindow>(width, height);
}

}  // namespace swaplight
