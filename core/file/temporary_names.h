#pragma once

#include <filesystem>

namespace swaplight {

/// A temporary file's name, known to removeTemporaryFiles() as long as this lives.
class TemporaryName {
 public:
  TemporaryName() = default;
  explicit TemporaryName(const std::filesystem::path& file);
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  TemporaryName(TemporaryName&& other) noexcept;
  TemporaryName& operator=(TemporaryName&& other) noexcept;
  ~TemporaryName() { forget(); }

 private:
  void forget();
  int m_slot = -1;
};

/// Removes the temporary files of this process; for one that ends without cleaning up. May be called from a
/// signal handler.
void removeTemporaryFiles() noexcept;

}  // namespace swaplight
