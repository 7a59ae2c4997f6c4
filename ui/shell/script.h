#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>

#include "ui/actions/script_line.h"
#include "ui/shell/studio_window.h"

namespace swaplight {

/// Commands for the studio, one a line, for demonstrations, screenshots and tests. `#` begins a comment.
///   open FILE              bring_in FOLDER        wait                   frames N
///   action ID              light NAME SETTING     select NAME
///   save FILE              export FILE            screenshot FILE
///   sleep SECONDS          say TEXT               quit
///   hover ITEM [X Y]       click ITEM [X Y]        menu ITEM [X Y]
///   drag ITEM X Y X Y      type TEXT
/// A mouse command names a widget and, as parts of its width and height, a place on it (default: its middle);
/// `menu` clicks with the right button.
class Script {
 public:
  /// Throws InputError where the file cannot be read.
  Script(const std::filesystem::path& file, std::function<void(const std::filesystem::path&)> screenshot);

  [[nodiscard]] bool done() const { return m_lines.empty() && m_mouse.empty() && m_frames == 0; }
  /// Runs what can be run before the next frame. Throws InputError that names the line.
  void step(StudioWindow& studio);

 private:
  /// False where the frame has to be drawn first.
  bool run(StudioWindow& studio, const ScriptLine& line);
  /// False where the command is none of the mouse's.
  bool runMouse(const ScriptLine& line);

  std::string m_name;
  std::deque<ScriptLine> m_lines;
  std::function<void(const std::filesystem::path&)> m_screenshot;
  struct MouseState {
    float x, y;
    bool left, right;
  };
  std::deque<MouseState> m_mouse;  ///< one a frame
  int m_frames = 0;                ///< to be drawn before the next line
};

}  // namespace swaplight
