#include "core/image/io/memory_file.h"

#include <unistd.h>

#include <cerrno>
#include <vector>

namespace swaplight {

MemoryFile::MemoryFile(const AtomicFile& file) : m_path(file.temporary().string()) {
#ifdef __linux__
  m_memory = namelessMemory();
  if (!m_memory) file.fail(errno);
  m_path = "/proc/self/fd/" + std::to_string(m_memory.get());
#endif
}

int MemoryFile::copyTo(FileProxy& disk) const {
  if (!m_memory) return 0;
  std::vector<char> block(size_t{1} << 20);
  off_t at = 0;
  while (true) {
    const ssize_t got = ::pread(m_memory.get(), block.data(), block.size(), at);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno;
    if (got == 0) return 0;
    disk.write(block.data(), static_cast<size_t>(got));
    at += got;
  }
}

}  // namespace swaplight
