#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "render/surface.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/tooltip_clock.h"
#include "ui/window/hidden_contexts.h"
#include "ui/window/window.h"

namespace swaplight {
namespace {

constexpr float kDoubleClickSeconds = 0.3F;
constexpr double kLongestDeaf = 1;  // seconds

std::string lastGlfwError() {
  const char* words = nullptr;
  glfwGetError(&words);
  return words ? words : "unknown reason";
}

/// GLFW as long as the window lives, and its window.
class GlfwWindow {
 public:
  GlfwWindow(const std::string& title, int width, int height, bool maximized) {
    if (glfwInit() == 0)
      throw ResourceError(fmt::format("no window: {}. Is there a display?", lastGlfwError()));
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_MAXIMIZED, maximized ? GLFW_TRUE : GLFW_FALSE);
    m_window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!m_window) {
      const std::string why = lastGlfwError();
      glfwTerminate();
      throw ResourceError(fmt::format("no window with OpenGL 4.1: {}", why));
    }
    glfwMakeContextCurrent(m_window);
    glfwSwapInterval(1);
  }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;
  ~GlfwWindow() {
    glfwDestroyWindow(m_window);
    glfwTerminate();
  }
  operator GLFWwindow*() const { return m_window; }  // NOLINT(google-explicit-constructor)

 private:
  GLFWwindow* m_window = nullptr;
};

std::string keyName(int key, int scancode) {
  static const std::map<int, const char*> names = {
      {GLFW_KEY_SPACE, "Space"},
      {GLFW_KEY_ESCAPE, "Escape"},
      {GLFW_KEY_ENTER, "Enter"},
      {GLFW_KEY_KP_ENTER, "Enter"},
      {GLFW_KEY_TAB, "Tab"},
      {GLFW_KEY_BACKSPACE, "Backspace"},
      {GLFW_KEY_DELETE, "Delete"},
      {GLFW_KEY_INSERT, "Insert"},
      {GLFW_KEY_HOME, "Home"},
      {GLFW_KEY_END, "End"},
      {GLFW_KEY_PAGE_UP, "PageUp"},
      {GLFW_KEY_PAGE_DOWN, "PageDown"},
      {GLFW_KEY_UP, "Up"},
      {GLFW_KEY_DOWN, "Down"},
      {GLFW_KEY_LEFT, "Left"},
      {GLFW_KEY_RIGHT, "Right"},
      {GLFW_KEY_LEFT_ALT, "Alt"},
      {GLFW_KEY_RIGHT_ALT, "Alt"},
      {GLFW_KEY_LEFT_SHIFT, "Shift"},
      {GLFW_KEY_RIGHT_SHIFT, "Shift"},
      {GLFW_KEY_LEFT_CONTROL, "Ctrl"},
      {GLFW_KEY_RIGHT_CONTROL, "Ctrl"},
      {GLFW_KEY_LEFT_SUPER, "Super"},
      {GLFW_KEY_RIGHT_SUPER, "Super"},
  };
  if (const auto found = names.find(key); found != names.end()) return found->second;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
  const char* printed = glfwGetKeyName(key, scancode);
  std::string name = printed ? printed : "";
  if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

class DesktopWindow : public Window {
 public:
  DesktopWindow(const std::string& title, int width, int height, bool maximized)
      : m_window(title, width, height, maximized) {
    glfwSetWindowUserPointer(m_window, this);
    installCallbacks();
    ImGui_ImplGlfw_InitForOpenGL(m_window, false);
    ImGui_ImplOpenGL3_Init("#version 410 core");
  }
  ~DesktopWindow() override {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
  }

  void wait(double seconds) override {
    m_contexts.createRequested();
    const double deaf = m_heard ? glfwGetTime() - *m_heard : 0;
    if (frameWanted())
      glfwPollEvents();
    else
      glfwWaitEventsTimeout(std::max(0.0, std::min(seconds, m_tooltipAt - glfwGetTime())));
    m_heard = glfwGetTime();
    // Of two clicks that were heard of after a slow frame nobody knows when in it they were made.
    ImGui::GetIO().MouseDoubleClickTime =
        kDoubleClickSeconds + static_cast<float>(std::min(deaf, kLongestDeaf));
    if (m_woken.exchange(false) || *m_heard >= m_tooltipAt) requestFrames();
  }

  void wake() override {
    m_woken = true;
    glfwPostEmptyEvent();
  }

  void beginFrame() override {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    feedInterface(m_input.frame());
    applyPretendedMouse();
    mannersBeforeFrame();
    ImGui::NewFrame();
    mannersFrame();
    tooltipClockFrame();
  }

  void endFrame() override {
    ImGui::Render();
    clearSurface(width(), height(), backgroundCode());
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (m_keepPixels) m_pixels = {width(), height(), readSurface(width(), height())};
    glfwSwapBuffers(m_window);
    m_tooltipAt = glfwGetTime() + secondsToTooltip();
    frameDone();
  }

  [[nodiscard]] int width() const override { return framebufferSize().first; }
  [[nodiscard]] int height() const override { return framebufferSize().second; }
  [[nodiscard]] float contentScale() const override {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(m_window, &x, &y);
    return x;
  }
  void keepPixels() override { m_keepPixels = true; }
  [[nodiscard]] Pixels pixels() override { return m_pixels; }

  void releaseWaitingThreads() override { m_contexts.close(); }

  [[nodiscard]] bool closeAsked() const override { return glfwWindowShouldClose(m_window) != 0; }
  void refuseClose() override { glfwSetWindowShouldClose(m_window, GLFW_FALSE); }
  void setTitle(const std::string& title) override { glfwSetWindowTitle(m_window, title.c_str()); }

  [[nodiscard]] std::optional<Place> place() const override {
    if (glfwGetWindowMonitor(m_window) || glfwGetWindowAttrib(m_window, GLFW_ICONIFIED) != 0)
      return std::nullopt;
    Place place;
    glfwGetWindowSize(m_window, &place.width, &place.height);
    place.maximized = glfwGetWindowAttrib(m_window, GLFW_MAXIMIZED) != 0;
    return place;
  }

  void toggleFullScreen() override {
    if (glfwGetWindowMonitor(m_window)) {
      glfwSetWindowMonitor(m_window, nullptr, m_place[0], m_place[1], m_place[2], m_place[3], 0);
      return;
    }
    glfwGetWindowPos(m_window, &m_place[0], &m_place[1]);
    glfwGetWindowSize(m_window, &m_place[2], &m_place[3]);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (mode) glfwSetWindowMonitor(m_window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  }

 private:
  static DesktopWindow& of(GLFWwindow* window) {
    return *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(window));
  }

  [[nodiscard]] std::pair<int, int> framebufferSize() const {
    int w = 0;
    int h = 0;
    glfwGetFramebufferSize(m_window, &w, &h);
    return {w, h};
  }

  // Every kind of input asks for frames, and waits in the queue for the frame that it belongs to.
  void installCallbacks() {
    glfwSetFramebufferSizeCallback(m_window, [](GLFWwindow* w, int, int) { of(w).requestFrames(); });
    glfwSetWindowRefreshCallback(m_window, [](GLFWwindow* w) { of(w).requestFrames(); });
    glfwSetWindowCloseCallback(m_window, [](GLFWwindow* w) { of(w).requestFrames(); });
    glfwSetWindowContentScaleCallback(m_window, [](GLFWwindow* w, float, float) { of(w).requestFrames(); });
    glfwSetWindowFocusCallback(m_window, [](GLFWwindow* w, int focused) {
      if (focused == 0) of(w).happened(FocusLost{});
      of(w).requestFrames();
    });
    installMouse();
    glfwSetCharCallback(m_window, [](GLFWwindow* w, unsigned code) {
      of(w).happened(TextTyped{static_cast<char32_t>(code)});
    });
    glfwSetKeyCallback(m_window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
      of(w).onKey(key, scancode, action, mods);
    });
    glfwSetDropCallback(m_window, [](GLFWwindow* w, int count, const char** paths) {
      of(w).requestFrames();
      for (int i = 0; i < count; ++i) of(w).m_dropped.emplace_back(paths[i]);
    });
  }

  void installMouse() {
    glfwSetCursorPosCallback(m_window, [](GLFWwindow* w, double x, double y) { of(w).pointerAt(x, y); });
    glfwSetCursorEnterCallback(m_window, [](GLFWwindow* w, int entered) {
      if (entered != 0)
        of(w).pointerIn();
      else if (!of(w).anyButtonDown())  // a drag goes on outside
        of(w).happened(PointerLeft{});
    });
    glfwSetMouseButtonCallback(m_window, [](GLFWwindow* w, int button, int action, int) {
      if (button < static_cast<int>(InputFrame::kButtons))
        of(w).happened(ButtonTurned{button, action == GLFW_PRESS});
    });
    glfwSetScrollCallback(m_window, [](GLFWwindow* w, double x, double y) {
      of(w).happened(WheelTurned{static_cast<float>(x), static_cast<float>(y)});
    });
    if (glfwGetWindowAttrib(m_window, GLFW_HOVERED) != 0) pointerIn();
  }

  void pointerAt(double x, double y) { happened(PointerMoved{static_cast<float>(x), static_cast<float>(y)}); }

  void pointerIn() {
    double x = 0;
    double y = 0;
    glfwGetCursorPos(m_window, &x, &y);
    pointerAt(x, y);
  }

  [[nodiscard]] bool anyButtonDown() const {
    for (int button = 0; button < static_cast<int>(InputFrame::kButtons); ++button)
      if (glfwGetMouseButton(m_window, button) != GLFW_RELEASE) return true;
    return false;
  }

  void onKey(int key, int scancode, int action, int mods) {
    KeyTurned turned;
    turned.code = key;
    turned.down = action != GLFW_RELEASE;
    turned.modifier = key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
    turned.types = key <= GLFW_KEY_WORLD_2 || (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL);
    turned.press = {keyName(key, scancode), (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0,
                    (mods & GLFW_MOD_ALT) != 0, action == GLFW_REPEAT};
    happened(std::move(turned));
  }

  GlfwWindow m_window;
  HiddenContexts m_contexts;
  std::atomic<bool> m_woken{false};
  std::optional<double> m_heard;  ///< when events were last asked for, in GLFW's time
  double m_tooltipAt = std::numeric_limits<double>::infinity();
  int m_place[4] = {100, 100, 1280, 720};
  bool m_keepPixels = false;
  Pixels m_pixels;
};

}  // namespace

std::unique_ptr<Window> openWindow(const std::string& title, int width, int height, bool maximized) {
  return std::make_unique<DesktopWindow>(title, width, height, maximized);
}

}  // namespace swaplight
