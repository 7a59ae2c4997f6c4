#include "ui/input/input_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace swaplight {
namespace {

using std::chrono::milliseconds;

constexpr InterfaceState kAtRest{false, true}, kTyping{true, true}, kOpening{false, false};

/// A queue, and the hands before it. What is done takes no time, unless `pass` says so.
struct Desk {
  InputQueue::Clock::time_point now{};
  InputQueue queue{now};

  void pass(int ms) { now += milliseconds(ms); }
  void move(float x, float y) { queue.push(PointerMoved{x, y}, now); }
  void button(bool down, int which = 0) { queue.push(ButtonTurned{which, down}, now); }
  void click() {
    button(true);
    button(false);
  }
  void key(const std::string& name, bool down, bool ctrl = false, bool repeat = false) {
    KeyTurned turned;
    turned.code = code(name);
    turned.down = down;
    turned.modifier = name == "Ctrl" || name == "Shift";
    turned.types = name.size() == 1;
    turned.press = {name, ctrl, false, false, repeat};
    queue.push(turned, now);
  }
  void press(const std::string& name, bool ctrl = false) {
    key(name, true, ctrl);
    key(name, false, ctrl);
  }
  /// As the desktop tells it: the key, what it types, the key again.
  void type(const std::string& text) {
    for (const char one : text) {
      key(std::string(1, one), true);
      queue.push(TextTyped{static_cast<char32_t>(one)}, now);
      key(std::string(1, one), false);
    }
  }
  static int code(const std::string& name) {
    int code = 0;
    for (const char one : name) code = 31 * code + one;
    return code % 500;
  }
  bool held(const std::string& name) const { return queue.frame().held.count(code(name)) > 0; }
  const InputFrame& frame(InterfaceState state = kAtRest) { return queue.next(state, now); }
  std::string pressesOf(InterfaceState state = kAtRest) {
    std::string names;
    for (const KeyPress& press : frame(state).keyboard.presses)
      names += (names.empty() ? "" : " ") + press.key;
    return names;
  }
};

TEST(InputQueue, AClickInsideOneFrameIsSeenDownAndThenUp) {
  Desk desk;
  desk.move(10, 20);
  desk.click();
  EXPECT_EQ(desk.frame().pointer, std::make_pair(10.0F, 20.0F));
  EXPECT_FALSE(desk.queue.frame().buttons[0])
      << "what lies below has to know first that the mouse is over it";
  EXPECT_TRUE(desk.frame().buttons[0]);
  EXPECT_FALSE(desk.frame().buttons[0]);
  EXPECT_TRUE(desk.queue.empty());
}

TEST(InputQueue, TwoClicksAreTwoClicks) {
  Desk desk;
  desk.click();
  desk.click();
  std::vector<bool> seen;
  while (!desk.queue.empty()) seen.push_back(desk.frame().buttons[0]);
  EXPECT_EQ(seen, (std::vector<bool>{true, false, true, false}));
}

TEST(InputQueue, ADragInsideOneFrameBeginsAndEndsWhereItDid) {
  Desk desk;
  desk.move(1, 1);
  desk.button(true);
  desk.move(5, 5);
  desk.move(9, 9);
  desk.button(false);
  desk.move(30, 30);
  desk.frame();
  EXPECT_TRUE(desk.frame().buttons[0]);
  EXPECT_EQ(desk.queue.frame().pointer->first, 1);
  EXPECT_TRUE(desk.frame().buttons[0]) << "still held at its last place";
  EXPECT_EQ(desk.queue.frame().pointer->first, 9);
  EXPECT_FALSE(desk.frame().buttons[0]);
  EXPECT_EQ(desk.queue.frame().pointer->first, 9);
  EXPECT_EQ(desk.frame().pointer->first, 30);
}

TEST(InputQueue, AKeyInsideOneFrameIsSeenDownAndThenUp) {
  Desk desk;
  desk.press("Delete");
  EXPECT_EQ(desk.pressesOf(), "Delete");
  EXPECT_TRUE(desk.held("Delete"));
  EXPECT_EQ(desk.pressesOf(), "");
  EXPECT_FALSE(desk.held("Delete"));
}

TEST(InputQueue, CtrlIsHeldWhenItsKeyIsSeen) {
  Desk desk;
  desk.key("Ctrl", true);
  desk.press("A", true);
  desk.key("Ctrl", false);
  EXPECT_EQ(desk.pressesOf(), "A");
  EXPECT_TRUE(desk.queue.frame().keyboard.isHeld("Ctrl"));
  desk.frame();
  EXPECT_FALSE(desk.queue.frame().keyboard.isHeld("Ctrl"));
  EXPECT_TRUE(desk.queue.empty());
}

TEST(InputQueue, CtrlStaysHeldUntilTheButtonIsLetGo) {
  Desk desk;
  desk.key("Ctrl", true);
  desk.click();
  desk.key("Ctrl", false);
  EXPECT_TRUE(desk.frame().buttons[0]);
  EXPECT_TRUE(desk.held("Ctrl"));
  EXPECT_FALSE(desk.frame().buttons[0]);
  EXPECT_TRUE(desk.held("Ctrl")) << "a button of the interface is pressed when the mouse is let go";
  desk.frame();
  EXPECT_FALSE(desk.held("Ctrl"));
}

TEST(InputQueue, TheWheelTurnsWithWhatWasHeld) {
  Desk desk;
  desk.key("Ctrl", true);
  desk.queue.push(WheelTurned{0, 1}, desk.now);
  desk.queue.push(WheelTurned{0, 1}, desk.now);
  desk.key("Ctrl", false);
  EXPECT_EQ(desk.frame().wheelY, 2);
  EXPECT_TRUE(desk.held("Ctrl"));
  EXPECT_EQ(desk.frame().wheelY, 0);
  EXPECT_FALSE(desk.held("Ctrl"));
}

TEST(InputQueue, TextComesInAtOnceIntoAField) {
  Desk desk;
  desk.type("golden hour");
  EXPECT_EQ(desk.frame(kTyping).text, U"golden hour");
  EXPECT_TRUE(desk.queue.empty());
}

TEST(InputQueue, TextBetweenTabsKeepsItsOrder) {
  Desk desk;
  desk.type("key");
  desk.press("Tab");
  desk.type("fill");
  desk.press("Enter");
  std::string seen;
  for (int frame = 0; frame < 20; ++frame) {
    const InputFrame& now = desk.frame(kTyping);
    for (const char32_t one : now.text) seen += static_cast<char>(one);
    for (const KeyPress& press : now.keyboard.presses)
      if (press.key.size() > 1) seen += "<" + press.key + ">";
    EXPECT_TRUE(now.text.empty() || !(desk.held("Tab") || desk.held("Enter"))) << "in one frame with text";
  }
  EXPECT_EQ(seen, "key<Tab>fill<Enter>");
}

TEST(InputQueue, WhatIsTypedAheadOfADialogWaitsForIt) {
  Desk desk;
  desk.key("Ctrl", true);
  desk.press("S", true);
  desk.key("Ctrl", false);
  desk.type("name");
  desk.press("Enter");
  EXPECT_EQ(desk.pressesOf(kAtRest), "S");
  for (int frame = 0; frame < 3; ++frame) {  // the dialog opens
    EXPECT_EQ(desk.pressesOf(kOpening), "");
    EXPECT_TRUE(desk.queue.frame().text.empty());
  }
  EXPECT_EQ(desk.frame(kTyping).text, U"name");
  EXPECT_EQ(desk.pressesOf(kTyping), "Enter");
}

TEST(InputQueue, ATypedKeyIsSeenAfterAClickThatMovesTheFocus) {
  Desk desk;
  desk.click();
  desk.type("12");
  desk.frame(kAtRest);
  desk.frame(kOpening);
  EXPECT_TRUE(desk.frame(kOpening).text.empty());
  EXPECT_EQ(desk.frame(kTyping).text, U"12");
}

TEST(InputQueue, WhatNeverRestsHoldsNothingUpForever) {
  Desk desk;
  desk.press("A");
  desk.press("B");
  EXPECT_EQ(desk.pressesOf(kOpening), "A");
  std::string seen;
  for (int frame = 0; frame < 20; ++frame) seen += desk.pressesOf(kOpening);
  EXPECT_EQ(seen, "B");
}

TEST(InputQueue, KeysOfActionsComeOneAFrame) {
  Desk desk;
  desk.type("ab");  // nothing is being typed into: they are keys of actions, and one may open a dialog
  EXPECT_EQ(desk.pressesOf(), "a");
  EXPECT_EQ(desk.queue.frame().keyboard.typed, U"a");
  EXPECT_TRUE(desk.queue.frame().text.empty());
  std::string seen;
  while (!desk.queue.empty()) seen += desk.pressesOf();
  EXPECT_EQ(seen, "b");
}

TEST(InputQueue, AHeldKeyRepeatsWithoutABacklog) {
  Desk desk;
  desk.key("]", true);
  for (int repeat = 0; repeat < 6; ++repeat) desk.key("]", true, false, true);
  desk.key("]", false);
  EXPECT_EQ(desk.pressesOf(), "]");
  std::string seen;
  int frames = 0;
  for (; !desk.queue.empty(); ++frames) seen += desk.pressesOf();
  EXPECT_EQ(seen, "] ] ] ] ] ]");
  EXPECT_LE(frames, 3) << "slow frames must not go on long after the key was let go";
}

TEST(InputQueue, TheClockFollowsTheHandsWhileThereIsMoreToCome) {
  Desk desk;
  desk.frame();
  desk.click();
  desk.pass(150);
  desk.click();
  desk.pass(800);  // a slow frame went by
  double between = 0;
  desk.frame();
  for (int frame = 0; frame < 2; ++frame) between += desk.frame().seconds;
  EXPECT_TRUE(desk.queue.frame().buttons[0]);
  EXPECT_NEAR(between, 0.150, 1e-3) << "a double click";
  EXPECT_NEAR(desk.frame().seconds, 0.8, 1e-3) << "all is seen: the clock is right again";
}

TEST(InputQueue, NothingIsHeldInAWindowWithoutTheKeyboard) {
  Desk desk;
  desk.key("Space", true);
  desk.frame();
  EXPECT_TRUE(desk.queue.frame().keyboard.isHeld("Space"));
  desk.queue.push(FocusLost{}, desk.now);
  desk.frame();
  EXPECT_TRUE(desk.queue.frame().focusLost);
  EXPECT_TRUE(desk.queue.frame().held.empty());
  EXPECT_FALSE(desk.queue.frame().keyboard.isHeld("Space"));
}

// Whatever is done at whatever speed: every change of a button or key is seen once, in order.
TEST(InputQueue, NothingIsLostOrTurnedRound) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    Desk desk;
    std::vector<std::string> done, seen;
    const std::vector<std::string> keys{"Tab", "Enter", "a", "b", "Delete", "Ctrl"};
    std::vector<bool> down(keys.size() + 1);
    std::vector<bool> shown(keys.size() + 1);
    const auto note = [](std::vector<std::string>& list, size_t which, bool on) {
      list.push_back(std::to_string(which) + (on ? "+" : "-"));
    };
    const auto look = [&] {
      const InterfaceState state{false, random() % 3 > 0};
      const InputFrame& frame = desk.frame(state);
      int changes = 0;
      for (size_t which = 0; which <= keys.size(); ++which) {
        const bool on =
            which == keys.size() ? frame.buttons[0] : frame.held.count(Desk::code(keys[which])) > 0;
        if (on == shown[which]) continue;
        note(seen, which, on);
        shown[which] = on;
        ++changes;
      }
      EXPECT_GT(frame.seconds, 0);
      return changes;
    };
    for (int event = 0; event < 30; ++event) {
      const size_t which = random() % (keys.size() + 1);
      down[which] = !down[which];
      note(done, which, down[which]);
      if (which == keys.size())
        desk.button(down[which]);
      else
        desk.key(keys[which], down[which]);
      desk.pass(static_cast<int>(random() % 30));
      if (random() % 4 == 0) look();
    }
    for (int frame = 0; frame < 500 && !desk.queue.empty(); ++frame) look();
    EXPECT_TRUE(desk.queue.empty());
    // Of one frame only what is independent: each button and key for itself is exact.
    for (size_t which = 0; which <= keys.size(); ++which) {
      const auto only = [&](const std::vector<std::string>& list) {
        std::vector<std::string> own;
        std::copy_if(list.begin(), list.end(), std::back_inserter(own),
                     [&](const std::string& one) { return one.starts_with(std::to_string(which)); });
        return own;
      };
      ASSERT_EQ(only(done), only(seen)) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace swaplight
