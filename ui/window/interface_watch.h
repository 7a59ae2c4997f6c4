#pragma once

#include <vector>

#include "ui/input/input_queue.h"

namespace swaplight {

/// Looks at Dear ImGui after every frame: where the focus is, and whether a dialog, a menu or a field is on
/// its way, which takes frames more without any input.
class InterfaceWatch {
 public:
  /// To be called between the frame's last widget and the next frame.
  void frameDrawn();
  [[nodiscard]] InterfaceState state() const { return m_state; }
  /// The next frame will look different, or may.
  [[nodiscard]] bool moves() const { return m_moves; }

 private:
  /// What the keyboard goes to.
  struct Focus {
    unsigned active = 0, navigated = 0, window = 0, popup = 0;
    int popups = 0, windows = 0;
    bool typing = false;
    bool operator==(const Focus&) const = default;
  };
  static Focus focusNow();
  /// A window that is drawn, and where, in pixels.
  struct Place {
    unsigned window = 0;
    float x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Place&) const = default;
  };
  static std::vector<Place> placesNow();

  Focus m_focus;
  std::vector<Place> m_places;
  unsigned m_hovered = 0;
  InterfaceState m_state;
  bool m_moves = true;
};

/// Hands a frame's input to Dear ImGui, before its new frame.
void feedInterface(const InputFrame& input);

}  // namespace swaplight
