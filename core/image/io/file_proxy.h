#pragma once

#include <OpenImageIO/filesystem.h>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace swaplight {

/// The file behind an OpenImageIO writer, because its own writers do not notice a full disk (PNG) or end
/// the process on one (JPEG): this one remembers the first error and lets the writer go on as if nothing had
/// happened.
class FileProxy : public OIIO::Filesystem::IOProxy {
 public:
  explicit FileProxy(const std::filesystem::path& file);

  // Not "file": OpenImageIO then takes it for its own class.
  [[nodiscard]] const char* proxytype() const override { return "watched file"; }
  bool seek(int64_t offset) override;
  size_t read(void* bytes, size_t count) override;
  size_t write(const void* bytes, size_t count) override;
  size_t pread(void* bytes, size_t count, int64_t offset) override;
  size_t pwrite(const void* bytes, size_t count, int64_t offset) override;
  [[nodiscard]] size_t size() const override { return static_cast<size_t>(m_size); }
  void flush() const override {}

  /// The errno of the first thing that went wrong; 0: nothing.
  [[nodiscard]] int failure() const { return m_failure; }
  /// Flushes and closes; returns failure().
  int finish();

 private:
  struct Close {
    void operator()(FILE* file) const { std::fclose(file); }
  };
  bool goTo(int64_t offset);
  void remember();

  std::unique_ptr<FILE, Close> m_stream;
  int64_t m_size = 0;
  int m_failure = 0;
  bool m_writing = false;  ///< the last thing done; between reading and writing a stream has to seek
};

}  // namespace swaplight
