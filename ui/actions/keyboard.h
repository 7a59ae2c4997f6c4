#pragma once

#include <set>
#include <string>
#include <vector>

namespace swaplight {

/// A key going down, by the name that stands on it under the person's layout: "A", "[", "F1", "Space",
/// "Escape", "Up".
struct KeyPress {
  std::string key;
  bool ctrl = false;
  bool shift = false;
  bool alt = false;
  bool repeat = false;  ///< held down long enough to fire again
};

/// What happened to the keyboard since the last frame, and what is held.
struct Keyboard {
  std::vector<KeyPress> presses;
  std::u32string typed;  ///< characters, for keys such as "?" that layouts put anywhere
  std::set<std::string> held;

  [[nodiscard]] bool isHeld(const std::string& key) const { return held.count(key) > 0; }
  void endFrame() {
    presses.clear();
    typed.clear();
  }
};

}  // namespace swaplight
