#include "ui/input/input_queue.h"

#include <algorithm>

namespace swaplight {
namespace {

constexpr double kLeastSeconds = 1e-5;  // the interface's clock must go on with every frame
// A dialog that was asked for in one frame is drawn in the next at the latest; what never comes to rest is
// not waited for.
constexpr int kFewestFrames = 2, kMostFrames = 12;

bool hasShortcut(const KeyPress& press) {
  return press.ctrl || press.alt;
}

}  // namespace

void InputQueue::push(InputEvent event, Clock::time_point when) {
  // The desktop tells of a key first, then of what it has typed: they belong together.
  if (const auto* text = std::get_if<TextTyped>(&event); text && !m_events.empty())
    if (auto* key = std::get_if<KeyTurned>(&m_events.back().event); key && key->down && key->types) {
      key->text += text->character;
      return;
    }
  m_events.push_back({std::move(event), when});
}

const InputFrame& InputQueue::next(InterfaceState interface, Clock::time_point now) {
  m_interface = interface;
  ++m_framesWaited;
  const bool rests = m_framesWaited >= kFewestFrames && interface.settled;
  if (rests || m_framesWaited >= kMostFrames) m_awaitsRest = false;
  m_share = {};
  m_frame.wheelX = m_frame.wheelY = 0;
  m_frame.text.clear();
  m_frame.keyboard.endFrame();
  m_frame.focusLost = false;
  Clock::time_point until = m_time;
  while (!m_events.empty() &&
         std::visit([this](const auto& event) { return take(event); }, m_events.front().event)) {
    until = std::max(until, m_events.front().when);
    m_events.pop_front();
  }
  if (m_events.empty()) until = std::max(until, now);
  m_frame.seconds = std::max(kLeastSeconds, std::chrono::duration<double>(until - m_time).count());
  m_time = until;
  return m_frame;
}

void InputQueue::swallowKeys() {
  for (const int code : m_share.keys) m_frame.held.erase(code);
  for (const KeyPress& press : m_frame.keyboard.presses) m_frame.keyboard.held.erase(press.key);
  m_frame.keyboard.presses.clear();
  m_frame.keyboard.typed.clear();
}

bool InputQueue::take(const PointerMoved& event) {
  if (m_share.turned || m_share.wheeled || m_share.pressed) return false;
  m_frame.pointer = {event.x, event.y};
  m_share.moved = true;
  return true;
}

bool InputQueue::take(const PointerLeft& /*event*/) {
  if (m_share.turned || m_share.wheeled || m_share.pressed) return false;
  m_frame.pointer.reset();
  m_share.moved = true;
  return true;
}

// Apart from moves before it: what is pressed has to know that the mouse is over it, and a drag that ends
// would otherwise lose its last part.
bool InputQueue::take(const ButtonTurned& event) {
  if (m_share.moved || m_share.turned || m_share.wheeled || m_share.pressed || m_share.typed) return false;
  m_frame.buttons.at(static_cast<size_t>(event.button)) = event.down;
  m_share.turned = true;
  awaitRest();
  return true;
}

bool InputQueue::take(const WheelTurned& event) {
  if (m_share.moved || m_share.turned || m_share.pressed) return false;
  m_frame.wheelX += event.x;
  m_frame.wheelY += event.y;
  m_share.wheeled = true;
  return true;
}

bool InputQueue::take(const KeyTurned& event) {
  if (!event.down) return takeRelease(event);
  if (event.modifier) return takeModifier(event);
  if (m_interface.typing && !event.text.empty() && !hasShortcut(event.press)) return takeText(event);
  return event.press.repeat ? takeRepeat(event) : takePress(event);
}

bool InputQueue::takeRelease(const KeyTurned& event) {
  if (m_share.keys.count(event.code) > 0) return false;
  if (event.modifier && (m_share.turned || m_share.wheeled || m_share.pressed)) return false;
  m_share.keys.insert(event.code);
  m_frame.held.erase(event.code);
  m_frame.keyboard.held.erase(event.press.key);
  return true;
}

bool InputQueue::takeModifier(const KeyTurned& event) {
  if (event.press.repeat) return true;
  if (m_share.turned || m_share.wheeled || m_share.pressed || m_share.keys.count(event.code) > 0)
    return false;
  // A field takes no text while Ctrl is held; Shift has done its part once there is text, and may come and
  // go.
  const bool shift = event.press.key == "Shift";
  if (m_share.typed && !shift) return false;
  if (!m_interface.typing || !shift) m_share.keys.insert(event.code);
  m_frame.held.insert(event.code);
  m_frame.keyboard.held.insert(event.press.key);
  return true;
}

bool InputQueue::takeText(const KeyTurned& event) {
  if (m_awaitsRest || m_share.turned || m_share.pressed) return false;
  m_frame.text += event.text;
  m_frame.held.insert(event.code);
  m_share.keys.erase(event.code);  // it has done its part, and may go up and down again
  pressed(event);
  m_share.typed = true;
  return true;
}

bool InputQueue::takeRepeat(const KeyTurned& event) {
  // A field repeats its keys by itself.
  if (m_interface.typing && !hasShortcut(event.press)) return true;
  if (m_awaitsRest || m_share.turned || m_share.wheeled || m_share.typed) return false;
  if (m_share.pressed && m_share.repeatsOnly != event.code) return false;
  m_share.pressed = true;
  m_share.repeatsOnly = event.code;
  pressed(event);
  return true;
}

bool InputQueue::takePress(const KeyTurned& event) {
  if (m_awaitsRest || m_share.turned || m_share.wheeled || m_share.pressed || m_share.typed ||
      m_share.keys.count(event.code) > 0)
    return false;
  m_share.pressed = true;
  m_share.keys.insert(event.code);
  m_frame.held.insert(event.code);
  pressed(event);
  awaitRest();
  return true;
}

void InputQueue::pressed(const KeyTurned& event) {
  m_frame.keyboard.held.insert(event.press.key);
  m_frame.keyboard.presses.push_back(event.press);
  m_frame.keyboard.typed += event.text;
}

bool InputQueue::take(const TextTyped& event) {
  if (m_awaitsRest || m_share.turned || m_share.pressed) return false;
  m_frame.keyboard.typed += event.character;
  if (m_interface.typing) {
    m_frame.text += event.character;
    m_share.typed = true;
    return true;
  }
  m_share.pressed = true;  // it may be the key of an action
  awaitRest();
  return true;
}

bool InputQueue::take(const FocusLost& /*event*/) {
  if (m_share.turned || m_share.pressed || m_share.typed) return false;
  m_frame.held.clear();
  m_frame.keyboard.held.clear();
  m_frame.focusLost = true;
  return true;
}

void InputQueue::awaitRest() {
  m_awaitsRest = true;
  m_framesWaited = 0;
}

}  // namespace swaplight
