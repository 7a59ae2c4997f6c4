#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "ui/actions/keyboard.h"

namespace swaplight {

/// One thing that the studio can do. Menus, buttons, keys, the command palette, scripts and tests all come
/// here.
struct Action {
  std::string id;       ///< "file.open": for scripts, key files and tests
  std::string name;     ///< "Open …"
  std::string keys;     ///< "Ctrl+O"; several apart by a space; empty: none
  std::string tooltip;  ///< one sentence
  std::function<void()> run;
  std::function<bool()> enabled = {};  ///< empty: always
  std::function<bool()> checked = {};  ///< empty: not a switch
  std::string ownKeys = {};            ///< the keys that it came with; set by the table
  bool keysTake = false;               ///< its keys switch it on only: a tool's keys take the tool

  [[nodiscard]] bool isEnabled() const { return !enabled || enabled(); }
  [[nodiscard]] bool isChecked() const { return checked && checked(); }
  /// The first of the keys.
  [[nodiscard]] std::string firstKeys() const { return keys.substr(0, keys.find(' ')); }
};

class ActionTable {
 public:
  void add(Action action);
  [[nodiscard]] const std::deque<Action>& actions() const { return m_actions; }
  /// nullptr where there is none.
  [[nodiscard]] const Action* find(const std::string& id) const;
  /// False where there is none or it is not enabled.
  bool run(const std::string& id) const;
  /// Runs the actions whose keys went down.
  void runKeys(const Keyboard& keyboard) const;
  void setKeys(const std::string& id, std::string keys);

 private:
  std::deque<Action> m_actions;
};

/// Whether a text has every word of a search somewhere, in any case.
[[nodiscard]] bool matchesWords(const std::string& text, const std::string& search);

/// "Ctrl+Shift+Z" from a key press: how keys are written in the table.
[[nodiscard]] std::string keysName(const KeyPress& press);

}  // namespace swaplight
