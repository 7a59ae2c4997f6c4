#include "core/session/history.h"

#include <algorithm>

namespace swaplight {

History::History(Document first, std::string name, size_t budgetBytes) : m_budget(budgetBytes) {
  const size_t bytes = documentBytes(first, {});
  m_steps.push_back({std::move(name), std::move(first), m_nextId++, bytes});
  m_bytes = bytes;
}

void History::commit(std::string name, Document next) {
  if (next == document()) return;
  while (canRedo()) {
    m_bytes -= m_steps.back().bytes;
    m_steps.pop_back();
  }
  const size_t bytes = documentBytes(next, document());
  m_steps.push_back({std::move(name), std::move(next), m_nextId++, bytes});
  m_bytes += bytes;
  m_position = m_steps.size() - 1;
  trim();
}

void History::goTo(size_t position) {
  m_position = std::min(position, m_steps.size() - 1);
}

void History::trim() {
  while (m_bytes > m_budget && m_position > 1) {
    m_bytes -= m_steps.front().bytes;
    m_steps.pop_front();
    --m_position;
  }
}

}  // namespace swaplight
