#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>

#include "ui/studio_window.h"

namespace swaplight {

/// Commands for the studio, one a line, for demonstrations, screenshots and tests. `#` begins a comment.
///   open FILE              wait                   frames N
///   action ID              light NAME SETTING     select NAME
///   save FILE              export FILE            screenshot FILE
///   sleep SECONDS          quit
class Script {
 public:
  /// Throws InputError where the file cannot be read.
  Script(const std::filesystem::path& file, std::function<void(const std::filesystem::path&)> screenshot);

  [[nodiscard]] bool done() const { return m_lines.empty(); }
  /// Runs what can be run before the next frame. Throws InputError that names the line.
  void step(StudioWindow& studio);

 private:
  struct Line {
    int number;
    std::string text;
  };
  /// False where the frame has to be drawn first.
  bool run(StudioWindow& studio, const Line& line);

  std::string m_name;
  std::deque<Line> m_lines;
  std::function<void(const std::filesystem::path&)> m_screenshot;
  int m_frames = 0;  ///< to be drawn before the next line
};

}  // namespace swaplight
