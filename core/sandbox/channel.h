#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace swaplight {

/// An open file descriptor; closed with its owner.
class OwnedDescriptor {
 public:
  OwnedDescriptor() = default;
  explicit OwnedDescriptor(int descriptor) : m_descriptor(descriptor) {}
  OwnedDescriptor(OwnedDescriptor&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}
  OwnedDescriptor& operator=(OwnedDescriptor&& other) noexcept {
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
  }
  OwnedDescriptor(const OwnedDescriptor&) = delete;
  OwnedDescriptor& operator=(const OwnedDescriptor&) = delete;
  ~OwnedDescriptor();
  [[nodiscard]] int get() const { return m_descriptor; }
  [[nodiscard]] explicit operator bool() const { return m_descriptor >= 0; }

 private:
  int m_descriptor = -1;
};

/// One end of a pair of sockets between two processes: messages, whole and in order, each with a file
/// descriptor or none. Whoever is at the other end may send anything: what comes is bytes, of bounded length.
class Channel {
 public:
  /// Throws ResourceError where the system gives none.
  [[nodiscard]] static std::pair<Channel, Channel> pair();
  Channel() = default;
  explicit Channel(OwnedDescriptor socket) : m_socket(std::move(socket)) {}

  [[nodiscard]] int descriptor() const { return m_socket.get(); }
  /// False where nobody is at the other end.
  [[nodiscard]] bool send(std::string_view message, int descriptor = -1) const;
  /// Waits. Nothing: the other end has closed, or what came is no message of at most `limit` bytes.
  [[nodiscard]] std::optional<std::string> receive(size_t limit, OwnedDescriptor* descriptor = nullptr) const;
  /// Whether receive() has something to do within the time.
  [[nodiscard]] bool waits(int milliseconds) const;

 private:
  OwnedDescriptor m_socket;
};

}  // namespace swaplight
