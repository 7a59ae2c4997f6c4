#pragma once

#include <cstddef>

#include "core/sandbox/channel.h"

namespace swaplight {

/// A file in memory, without a name; gone with the last who has it open. An empty one where the system gives
/// none.
[[nodiscard]] OwnedDescriptor namelessMemory();

/// Memory that two processes see: one makes it and sends its descriptor, the other maps it.
class SharedMemory {
 public:
  SharedMemory() = default;
  /// Makes it. Throws std::bad_alloc, and ResourceError where the limit of file sizes forbids it.
  explicit SharedMemory(size_t bytes);
  /// Maps what another process has made. Throws std::bad_alloc.
  SharedMemory(OwnedDescriptor descriptor, size_t bytes);
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  ~SharedMemory();

  [[nodiscard]] std::byte* data() const { return m_data; }
  [[nodiscard]] int descriptor() const { return m_descriptor.get(); }

 private:
  void map();
  OwnedDescriptor m_descriptor;
  size_t m_size = 0;
  std::byte* m_data = nullptr;
};

}  // namespace swaplight
