#include "ui/jobs/messages.h"

#include <algorithm>
#include <utility>

#include "core/base/option_hints.h"
#include "core/diagnosis/program_log.h"

namespace swaplight {
namespace {

constexpr size_t kMostShown = 5;

using Clock = std::chrono::steady_clock;

Clock::time_point endOf(Messages::Kind kind, const std::string& text) {
  if (kind == Messages::Kind::Error) return Clock::time_point::max();
  // Reading takes about 15 characters a second.
  return Clock::now() + std::chrono::milliseconds(3000 + 66 * static_cast<int>(text.size()));
}

}  // namespace

void Messages::say(Message message) {
  const Kind kind = message.kind;
  logLine((kind == Kind::Error ? "error: " : kind == Kind::Warning ? "warning: " : "") + message.text);
  message.text = withoutOptionHints(message.text);
  message.until = endOf(kind, message.text);
  std::erase_if(m_messages,
                [&](const Message& said) { return said.kind == kind && said.text == message.text; });
  m_messages.push_back(std::move(message));
  if (m_messages.size() > kMostShown) m_messages.pop_front();
}

void Messages::succeeded(const void* work) {
  std::erase_if(m_messages, [&](const Message& message) { return work && message.work == work; });
}

void Messages::forgetErrors() {
  std::erase_if(m_messages,
                [](const Message& message) { return message.kind == Kind::Error && !message.stays; });
}

bool Messages::expire() {
  const size_t before = m_messages.size();
  const Clock::time_point now = Clock::now();
  std::erase_if(m_messages, [&](const Message& message) { return message.until <= now; });
  return m_messages.size() != before;
}

}  // namespace swaplight
