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
    const void* work = nullptr;  ///< of an error: what failed
    bool stays = false;          ///< it is not about what is open
  };

  /// Errors stay until they are clicked away, or what they are about is gone. What is said again is shown
  /// once.
  void say(Kind kind, const std::string& text) { say({kind, text, {}}); }
  void info(const std::string& text) { say(Kind::Info, text); }
  void warn(const std::string& text) { say(Kind::Warning, text); }
  void error(const std::string& text) { say(Kind::Error, text); }
  /// About the program and its surroundings, whatever is open.
  void errorThatStays(const std::string& text) { say({Kind::Error, text, {}, nullptr, true}); }
  /// `work`, an address that it has for itself, has failed, or succeeded: what it failed with before goes.
  void failed(const void* work, const std::string& text) { say({Kind::Error, text, {}, work}); }
  void succeeded(const void* work);
  /// Something else is open: errors of before go.
  void forgetErrors();

  /// Forgets what has been shown long enough; true where that changed anything.
  bool expire();
  void dismiss(size_t index) { m_messages.erase(m_messages.begin() + static_cast<ptrdiff_t>(index)); }
  [[nodiscard]] const std::deque<Message>& messages() const { return m_messages; }

 private:
  void say(Message message);

  std::deque<Message> m_messages;
};

}  // namespace swaplight
