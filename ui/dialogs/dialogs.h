#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ui/control/session_controller.h"

namespace swaplight {

/// Asks what becomes of unsaved work before it would be lost.
class UnsavedDialog {
 public:
  struct Question {
    std::string name;            ///< of the session
    std::function<void()> save;  ///< saves, then goes on
    std::function<void()> goOn;  ///< goes on without saving
    std::function<void()> stay;  ///< goes back; may be empty
  };
  void ask(Question question) { m_question = std::move(question); }
  [[nodiscard]] bool isOpen() const { return m_question.has_value(); }
  void draw();

 private:
  std::optional<Question> m_question;
};

/// Offers what a studio that died has left.
class RecoveryDialog {
 public:
  void draw(SessionController& session);

 private:
  bool m_dismissed = false;
};

}  // namespace swaplight
