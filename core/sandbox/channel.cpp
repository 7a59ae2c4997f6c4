#include "core/sandbox/channel.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"

namespace swaplight {
namespace {

#ifndef MSG_NOSIGNAL
constexpr int MSG_NOSIGNAL = 0;  // a Mac: the program ignores SIGPIPE
#endif

/// Room for one descriptor beside the bytes.
struct DescriptorMessage {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  iovec bytes{};
  msghdr header{};

  DescriptorMessage(void* data, size_t size, bool withDescriptor) {
    bytes = {data, size};
    header.msg_iov = &bytes;
    header.msg_iovlen = 1;
    if (!withDescriptor) return;
    header.msg_control = control.data();
    header.msg_controllen = control.size();
  }
};

bool sendAll(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<size_t>(sent));
  }
  return true;
}

bool receiveAll(int socket, char* to, size_t count) {
  while (count > 0) {
    const ssize_t got = ::recv(socket, to, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    count -= static_cast<size_t>(got);
  }
  return true;
}

/// The length of a message, with which its descriptor comes.
bool sendLength(int socket, uint64_t length, int descriptor) {
  DescriptorMessage message(&length, sizeof length, descriptor >= 0);
  if (descriptor >= 0) {
    cmsghdr* control = CMSG_FIRSTHDR(&message.header);
    control->cmsg_level = SOL_SOCKET;
    control->cmsg_type = SCM_RIGHTS;
    control->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(control), &descriptor, sizeof descriptor);
  }
  ssize_t sent = 0;
  do {
    sent = ::sendmsg(socket, &message.header, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent == static_cast<ssize_t>(sizeof length);
}

bool receiveLength(int socket, uint64_t& length, OwnedDescriptor& descriptor) {
  DescriptorMessage message(&length, sizeof length, true);
  ssize_t got = 0;
  do {
    got = ::recvmsg(socket, &message.header, MSG_WAITALL);
  } while (got < 0 && errno == EINTR);
  if (const cmsghdr* control = got > 0 ? CMSG_FIRSTHDR(&message.header) : nullptr;
      control && control->cmsg_level == SOL_SOCKET && control->cmsg_type == SCM_RIGHTS) {
    int received = -1;
    std::memcpy(&received, CMSG_DATA(control), sizeof received);
    ::fcntl(received, F_SETFD, FD_CLOEXEC);
    descriptor = OwnedDescriptor(received);
  }
  return got == static_cast<ssize_t>(sizeof length);
}

}  // namespace

OwnedDescriptor::~OwnedDescriptor() {
  if (m_descriptor >= 0) ::close(m_descriptor);
}

std::pair<Channel, Channel> Channel::pair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0)
    throw ResourceError(std::string("a process for pictures cannot be reached: ") + std::strerror(errno));
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  return {Channel(OwnedDescriptor(ends[0])), Channel(OwnedDescriptor(ends[1]))};
}

bool Channel::send(std::string_view message, int descriptor) const {
  return sendLength(m_socket.get(), message.size(), descriptor) && sendAll(m_socket.get(), message);
}

std::optional<std::string> Channel::receive(size_t limit, OwnedDescriptor* descriptor) const {
  uint64_t length = 0;
  OwnedDescriptor received;
  if (!receiveLength(m_socket.get(), length, received) || length > limit) return std::nullopt;
  std::string message(length, '\0');
  if (!receiveAll(m_socket.get(), message.data(), message.size())) return std::nullopt;
  if (descriptor) *descriptor = std::move(received);
  return message;
}

bool Channel::waits(int milliseconds) const {
  pollfd wait{m_socket.get(), POLLIN, 0};
  return ::poll(&wait, 1, milliseconds) > 0;
}

}  // namespace swaplight
