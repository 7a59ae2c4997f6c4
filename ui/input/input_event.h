#pragma once

#include <string>
#include <variant>

#include "ui/actions/keyboard.h"

namespace swaplight {

// What the desktop tells about the mouse and the keyboard, one thing at a time, in the order in which it
// happened.

/// To a place in the window, in pixels.
struct PointerMoved {
  float x = 0, y = 0;
};
/// Out of the window.
struct PointerLeft {};

struct ButtonTurned {
  int button = 0;  ///< 0 left, 1 right, 2 middle
  bool down = false;
};

struct WheelTurned {
  float x = 0, y = 0;  ///< in notches
};

/// A key went down, went down again because it is held, or went up.
struct KeyTurned {
  int code = 0;    ///< the desktop's number of the key
  KeyPress press;  ///< its name, and what was held with it
  bool down = false;
  bool modifier = false;  ///< Ctrl, Shift, Alt or Super: changes what other keys and buttons mean
  bool types = false;     ///< it is a key of letters, digits or signs: a TextTyped may follow
  std::u32string text{};  ///< what it has typed
};

/// Typed by the key before it, or by an input method.
struct TextTyped {
  char32_t character = 0;
};

/// Another window has the keyboard now: nothing is held any more.
struct FocusLost {};

using InputEvent =
    std::variant<PointerMoved, PointerLeft, ButtonTurned, WheelTurned, KeyTurned, TextTyped, FocusLost>;

}  // namespace swaplight
