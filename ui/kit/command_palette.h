#pragma once

#include <string>

#include "ui/actions/action_table.h"

namespace swaplight {

/// Every action by a few letters of its name.
class CommandPalette {
 public:
  void open() { m_opening = true; }
  [[nodiscard]] bool isOpen() const { return m_opening || m_open; }
  void draw(const ActionTable& actions);

 private:
  bool m_opening = false;
  bool m_open = false;
  std::string m_filter;
  int m_chosen = 0;
};

}  // namespace swaplight
