#include "core/image/io/file_proxy.h"

#include <algorithm>
#include <cerrno>

namespace swaplight {
namespace {

constexpr size_t kBuffer = size_t{1} << 20;

}  // namespace

FileProxy::FileProxy(const std::filesystem::path& file)
    : IOProxy(file.string(), Write), m_stream(std::fopen(file.c_str(), "w+be")) {
  if (m_stream)
    std::setvbuf(m_stream.get(), nullptr, _IOFBF, kBuffer);
  else
    remember();
}

void FileProxy::remember() {
  if (m_failure == 0) m_failure = errno != 0 ? errno : EIO;
}

bool FileProxy::seek(int64_t offset) {
  m_pos = offset;
  return true;
}

bool FileProxy::goTo(int64_t offset) {
  if (m_failure != 0) return false;
  if (fseeko(m_stream.get(), offset, SEEK_SET) == 0) return true;
  remember();
  return false;
}

size_t FileProxy::pread(void* bytes, size_t count, int64_t offset) {
  m_writing = false;
  return goTo(offset) ? std::fread(bytes, 1, count, m_stream.get()) : 0;
}

size_t FileProxy::pwrite(const void* bytes, size_t count, int64_t offset) {
  // Seeking empties the stream's buffer: only where it is not there yet, or was read.
  const bool there = m_failure == 0 && m_writing && ftello(m_stream.get()) == offset;
  m_writing = true;
  if ((there || goTo(offset)) && std::fwrite(bytes, 1, count, m_stream.get()) != count) remember();
  m_size = std::max(m_size, offset + static_cast<int64_t>(count));
  return count;
}

size_t FileProxy::read(void* bytes, size_t count) {
  const size_t got = pread(bytes, count, m_pos);
  m_pos += static_cast<int64_t>(got);
  return got;
}

size_t FileProxy::write(const void* bytes, size_t count) {
  const size_t written = pwrite(bytes, count, m_pos);
  m_pos += static_cast<int64_t>(written);
  return written;
}

int FileProxy::finish() {
  if (m_stream && std::fclose(m_stream.release()) != 0) remember();
  return m_failure;
}

}  // namespace swaplight
