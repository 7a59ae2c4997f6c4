#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "ui/actions/keyboard.h"
#include "ui/input/input_event.h"

namespace swaplight {

/// What the interface sees of the mouse and the keyboard in one frame.
struct InputFrame {
  static constexpr size_t kButtons = 5;

  std::optional<std::pair<float, float>> pointer;  ///< in pixels of the window; nothing: it is elsewhere
  std::array<bool, kButtons> buttons{};            ///< which are down
  float wheelX = 0, wheelY = 0;                    ///< notches since the last frame
  std::set<int> held;                              ///< codes of the keys that are down
  std::u32string text;                             ///< for the field that is being typed into
  Keyboard keyboard;                               ///< for the actions that have keys
  bool focusLost = false;
  double seconds = 0;  ///< by which the interface's clock goes on, more than 0
};

/// How the interface stood after the last frame.
struct InterfaceState {
  bool typing = false;  ///< a field of text takes what is typed
  bool settled = true;  ///< no dialog is being opened or closed, nothing is getting or losing the focus
};

/// Stands between the desktop and the interface, which looks at the state of mouse and keyboard once a frame.
/// However slow frames are, nothing that happens between two of them is lost, and all of it arrives in order:
///
/// - What changes the state (a button or key going down or up) has a frame of its own, apart from moves and
/// text
///   before it, as the event queue of Dear ImGui since 1.87 does.
/// - A key or a click may open a dialog or move the focus. Keys and text after it wait until the interface
/// has
///   come to rest, so that they go where a person who typed ahead means them to go.
/// - Text that is typed into a field comes in as many characters a frame as there are.
/// - While there is more to come, the interface's clock follows the events and not the frames: what makes a
/// double
///   click, or a key that repeats, is how quick the person was.
class InputQueue {
 public:
  using Clock = std::chrono::steady_clock;

  explicit InputQueue(Clock::time_point start = Clock::now()) : m_time(start) {}

  void push(InputEvent event, Clock::time_point when);
  [[nodiscard]] bool empty() const { return m_events.empty(); }

  /// The next frame's share of what has happened.
  const InputFrame& next(InterfaceState interface, Clock::time_point now);
  /// The keys that went down in this frame count as not pressed.
  void swallowKeys();
  /// What the last call of next() gave.
  [[nodiscard]] const InputFrame& frame() const { return m_frame; }

 private:
  struct Entry {
    InputEvent event;
    Clock::time_point when;
  };
  /// What the frame holds so far.
  struct Share {
    bool moved = false, turned = false, wheeled = false, pressed = false, typed = false;
    std::set<int> keys;              ///< that went down or up, those that only typed aside
    std::optional<int> repeatsOnly;  ///< all that was pressed is this key, held
  };

  // Each takes an event into the frame, or says that it has to wait for the next one.
  bool take(const PointerMoved& event);
  bool take(const PointerLeft& event);
  bool take(const ButtonTurned& event);
  bool take(const WheelTurned& event);
  bool take(const KeyTurned& event);
  bool take(const TextTyped& event);
  bool take(const FocusLost& event);

  bool takeRelease(const KeyTurned& event);
  bool takeModifier(const KeyTurned& event);
  bool takeText(const KeyTurned& event);
  bool takeRepeat(const KeyTurned& event);
  bool takePress(const KeyTurned& event);
  void pressed(const KeyTurned& event);

  /// What follows waits for rest.
  void awaitRest();

  std::deque<Entry> m_events;
  InputFrame m_frame;
  Share m_share;
  InterfaceState m_interface;
  bool m_awaitsRest = false;
  int m_framesWaited = 0;
  Clock::time_point m_time;  ///< of the interface
};

}  // namespace swaplight
