#pragma once

#include <string>

#include "core/session/history.h"

namespace swaplight {

/// The document as the person sees it: the history, and on top of it the gesture that is under way (a slider
/// held, a stroke). However many previews a gesture makes, it becomes one step.
class DocumentEditor {
 public:
  /// What is shown: the gesture's document while there is one.
  [[nodiscard]] const Document& document() const { return m_live; }
  [[nodiscard]] const History& history() const { return m_history; }
  /// Counts up whenever document() changes; for those who cache what they make of it.
  [[nodiscard]] uint64_t revision() const { return m_revision; }
  [[nodiscard]] bool inGesture() const { return m_inGesture; }
  /// The name that the gesture was last previewed by.
  [[nodiscard]] const std::string& gesture() const { return m_gesture; }

  /// Shows `next` without making a step yet. A preview of another name than the last begins another gesture.
  void preview(const std::string& name, Document next);
  /// Ends the gesture as one step, named as it was previewed; nothing happens without one.
  void commit();
  /// Ends the gesture as if it had never begun.
  void cancel();
  /// One step at once. A gesture that is under way becomes a step of its own first.
  void edit(std::string name, Document next);

  void undo();
  void redo();
  void goTo(size_t position);
  void markSaved(uint64_t stepId) { m_history.markSaved(stepId); }
  void markUnsaved() { m_history.markUnsaved(); }
  /// True where everything shown is in the file.
  [[nodiscard]] bool saved() const { return m_history.saved() && !m_inGesture; }

  /// Another document: a new history that begins with it.
  void reset(Document document, std::string name);

 private:
  void show(const Document& document);

  History m_history;
  Document m_live;
  bool m_inGesture = false;
  std::string m_gesture;  ///< its name
  uint64_t m_revision = 0;
};

}  // namespace swaplight
