#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/actions/keyboard.h"
#include "ui/input/input_queue.h"
#include "ui/window/interface_watch.h"

namespace swaplight {

/// Where the studio draws and where its input comes from: a window of the desktop, or a picture in memory.
/// Feeds Dear ImGui, whose context the caller has made; owns the OpenGL context, current on this thread.
class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  virtual ~Window() = default;

  /// Sleeps until there is input, somebody calls wake(), or the seconds are over; not at all while frames are
  /// wanted, and no longer than until a tooltip is due.
  virtual void wait(double seconds) = 0;
  /// From any thread: ends wait() and asks for a frame.
  virtual void wake() = 0;
  /// At the beginning of a frame: its share of the input is what keyboard() and Dear ImGui see.
  void nextInput();
  /// The keys of this frame have been heard: nobody else sees them.
  void swallowKeys() { m_input.swallowKeys(); }
  /// Dear ImGui may be drawn with from here until endFrame().
  virtual void beginFrame() = 0;
  /// Draws and shows.
  virtual void endFrame() = 0;

  [[nodiscard]] virtual int width() const = 0;
  [[nodiscard]] virtual int height() const = 0;
  /// Of the desktop: 1 at 96 dots an inch.
  [[nodiscard]] virtual float contentScale() const { return 1; }
  struct Pixels {
    int width = 0, height = 0;  ///< 0 where no frame was kept yet
    std::vector<uint8_t> rgba;  ///< 8-bit R G B A from the top
  };
  /// What the last frame looked like.
  [[nodiscard]] virtual Pixels pixels() = 0;

  /// The studio ends: threads that wait for the window to create an OpenGL context stop waiting.
  virtual void releaseWaitingThreads() {}

  [[nodiscard]] virtual bool closeAsked() const { return false; }
  virtual void refuseClose() {}
  virtual void setTitle(const std::string& /*title*/) {}
  virtual void toggleFullScreen() {}
  /// How it stands on the desktop; nothing where it fills the screen, or there is no desktop.
  struct Place {
    int width = 0, height = 0;  ///< in units of the desktop
    bool maximized = false;
  };
  [[nodiscard]] virtual std::optional<Place> place() const { return std::nullopt; }
  /// Frames are kept from the next one on, for pixels().
  virtual void keepPixels() {}

  /// Dear ImGui needs a few frames to come to rest after anything happened.
  void requestFrames(int count = 3) { m_framesWanted = std::max(m_framesWanted, count); }
  [[nodiscard]] bool frameWanted() const { return m_framesWanted > 0 || !m_input.empty(); }
  [[nodiscard]] const Keyboard& keyboard() const { return m_input.frame().keyboard; }
  /// From the next frame on the mouse is here, whatever the real one does: for scripts and measurements.
  void pretendMouse(float x, float y, bool down, bool right = false) {
    m_pretended = {true, x, y, down, right};
  }

  /// Files that were dropped onto the window since the last call.
  [[nodiscard]] std::vector<std::filesystem::path> takeDropped() { return std::exchange(m_dropped, {}); }

 protected:
  void frameDone();
  void happened(InputEvent event) { m_input.push(std::move(event), InputQueue::Clock::now()); }
  /// To be called between the backend's new frame and Dear ImGui's.
  void applyPretendedMouse() const;

  struct Pretended {
    bool on = false;
    float x = 0, y = 0;
    bool down = false, right = false;
  };
  Pretended m_pretended;
  InputQueue m_input;
  InterfaceWatch m_watch;
  std::vector<std::filesystem::path> m_dropped;
  int m_framesWanted = 3;
};

/// A window. Throws ResourceError where there is no display or no OpenGL 4.1.
[[nodiscard]] std::unique_ptr<Window> openWindow(const std::string& title, int width, int height,
                                                 bool maximized = false);
/// A picture in memory; needs no display. Throws ResourceError where there is no OpenGL 4.1.
[[nodiscard]] std::unique_ptr<Window> openOffscreen(int width, int height);

}  // namespace swaplight
