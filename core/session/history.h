#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "core/session/document.h"

namespace swaplight {

/// Undo by value: every document that was, with the name of the step that made it. Steps are dropped from the
/// old end when they hold more than a budget of memory; the current one and its neighbours always stay.
class History {
 public:
  struct Step {
    std::string name;  ///< what the person did, as "Key: 3200 K"
    Document document;
    uint64_t id;   ///< never used again
    size_t bytes;  ///< what the step holds beyond the one before
  };

  explicit History(Document first = {}, std::string name = "Start", size_t budgetBytes = size_t{256} << 20);

  [[nodiscard]] const Document& document() const { return m_steps[m_position].document; }
  [[nodiscard]] const std::deque<Step>& steps() const { return m_steps; }
  [[nodiscard]] size_t position() const { return m_position; }
  [[nodiscard]] uint64_t stepId() const { return m_steps[m_position].id; }
  [[nodiscard]] size_t bytes() const { return m_bytes; }

  /// Adds a step after the current one; what had been undone is forgotten. Nothing happens where the document
  /// is the one that is there.
  void commit(std::string name, Document next);

  [[nodiscard]] bool canUndo() const { return m_position > 0; }
  [[nodiscard]] bool canRedo() const { return m_position + 1 < m_steps.size(); }
  void undo() { goTo(m_position - (canUndo() ? 1 : 0)); }
  void redo() { goTo(m_position + (canRedo() ? 1 : 0)); }
  /// To any step of the list; a position beyond the end means the last.
  void goTo(size_t position);

  /// This step is what the file holds: the current one when saving began. Undoing back to it is "saved"
  /// again.
  void markSaved(uint64_t id) { m_savedId = id; }
  /// No step is in a file: what was recovered after a crash.
  void markUnsaved() { m_savedId = ~uint64_t{0}; }
  [[nodiscard]] bool saved() const { return m_savedId == stepId(); }

 private:
  void trim();

  std::deque<Step> m_steps;
  size_t m_position = 0;
  size_t m_bytes = 0;
  size_t m_budget;
  uint64_t m_nextId = 0;
  uint64_t m_savedId = 0;
};

}  // namespace swaplight
