#pragma once

#include <filesystem>
#include <string>

#include "ui/actions/action_table.h"
#include "ui/jobs/messages.h"

namespace swaplight {

/// The help: every action with its keys, searchable; a click on keys changes them.
class KeysWindow {
 public:
  explicit KeysWindow(std::filesystem::path file) : m_file(std::move(file)) {}
  void toggle() { m_open = !m_open; }
  [[nodiscard]] bool isOpen() const { return m_open; }
  /// Escape: closes it, unless a shortcut is awaited, which then is not changed.
  bool escape() {
    if (!m_open || !m_waiting.empty()) return false;
    m_open = false;
    return true;
  }
  void draw(ActionTable& actions, const Keyboard& keyboard, Messages& messages);

 private:
  void drawGroup(ActionTable& actions, const std::string& group);
  void takeKeys(ActionTable& actions, const Keyboard& keyboard, Messages& messages);

  std::filesystem::path m_file;
  bool m_open = false;
  std::string m_filter;
  std::string m_waiting;  ///< id of the action that gets the next keys
};

}  // namespace swaplight
