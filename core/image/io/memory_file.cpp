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

void MemoryFile::copyTo(FileProxy& disk) const {
  if (!m_memory) return;
  std::vector<char> block(size_t{1} << 20);
  off_t at = 0;
  ssize_t got = 0;
  while ((got = ::pread(m_memory.get(), block.data(), block.size(), at)) > 0) {
    disk.write(block.data(), static_cast<size_t>(got));
    at += got;
  }
}

}  // namespace swaplight
