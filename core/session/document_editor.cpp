#include "core/session/document_editor.h"

namespace swaplight {

void DocumentEditor::show(const Document& document) {
  m_inGesture = false;
  if (m_live == document) return;
  m_live = document;
  ++m_revision;
}

void DocumentEditor::preview(const std::string& name, Document next) {
  if (m_gesture != name) commit();
  m_inGesture = true;
  m_gesture = name;
  if (m_live == next) return;
  m_live = std::move(next);
  ++m_revision;
}

void DocumentEditor::commit() {
  if (!m_inGesture) return;
  m_inGesture = false;
  m_history.commit(m_gesture, m_live);
}

void DocumentEditor::cancel() {
  if (m_inGesture) show(m_history.document());
}

void DocumentEditor::edit(std::string name, Document next) {
  commit();
  m_history.commit(std::move(name), std::move(next));
  show(m_history.document());
}

void DocumentEditor::undo() {
  goTo(m_history.position() > 0 && !m_inGesture ? m_history.position() - 1 : m_history.position());
}

void DocumentEditor::redo() {
  goTo(m_history.position() + 1);
}

void DocumentEditor::goTo(size_t position) {
  m_history.goTo(position);
  show(m_history.document());
}

void DocumentEditor::reset(Document document, std::string name) {
  m_history = History(std::move(document), std::move(name));
  show(m_history.document());
}

}  // namespace swaplight
