#include "core/sandbox/shared_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <new>

#include "core/base/error.h"
#ifndef __linux__
#include <random>
#include <string>
#endif

namespace swaplight {
OwnedDescriptor namelessMemory() {
#ifdef __linux__
  return OwnedDescriptor(::memfd_create("swaplight picture", MFD_CLOEXEC | MFD_ALLOW_SEALING));
#else
  const std::string name = "/swaplight-" + std::to_string(std::random_device()());
  OwnedDescriptor memory(::shm_open(name.c_str(), O_CREAT | O_EXCL | O_RDWR, 0600));
  ::shm_unlink(name.c_str());
  return memory;
#endif
}

SharedMemory::SharedMemory(size_t bytes) : m_descriptor(namelessMemory()), m_size(bytes) {
  if (!m_descriptor || ::ftruncate(m_descriptor.get(), static_cast<off_t>(bytes)) != 0) {
    if (m_descriptor && errno == EFBIG)
      throw ResourceError(
          "a decoded picture is larger than this shell lets a file be (ulimit -f), memory that processes "
          "share included; raise the limit (--trust-pictures does without)");
    throw std::bad_alloc();
  }
#ifdef __linux__
  // Who has it cannot cut it under the other's eyes.
  if (::fcntl(m_descriptor.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)
    throw std::bad_alloc();
#endif
  map();
}

SharedMemory::SharedMemory(OwnedDescriptor descriptor, size_t bytes)
    : m_descriptor(std::move(descriptor)), m_size(bytes) {
  map();
}

void SharedMemory::map() {
  void* data = ::mmap(nullptr, m_size, PROT_READ | PROT_WRITE, MAP_SHARED, m_descriptor.get(), 0);
  if (data == MAP_FAILED) throw std::bad_alloc();
  m_data = static_cast<std::byte*>(data);
}

SharedMemory::~SharedMemory() {
  if (m_data) ::munmap(m_data, m_size);
}

}  // namespace swaplight
