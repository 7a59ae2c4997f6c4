#pragma once

#include <chrono>
#include <deque>
#include <string>

namespace swaplight {

/// What the studio has to say without asking for anything: shown over the viewer for a while.
class Messages {
 public:
  enum class Kind { Info, Warning, Error };
  struct Message {
    Kind kind;
    std::string text;
    std::chrono::steady_clock::time_point until;
  };

  /// Errors stay until they are clicked away.
  void say(Kind kind, const std::string& text);
  void info(const std::string& text) { say(Kind::Info, text); }
  void warn(const std::string& text) { say(Kind::Warning, text); }
  void error(const std::string& text) { say(Kind::Error, text); }

  /// Forgets what has been shown long enough; true where that changed anything.
  bool expire();
  void dismiss(size_t index) { m_messages.erase(m_messages.begin() + static_cast<ptrdiff_t>(index)); }
  [[nodiscard]] const std::deque<Message>& messages() const { return m_messages; }

 private:
  std::deque<Message> m_messages;
};

}  // namespace swaplight
