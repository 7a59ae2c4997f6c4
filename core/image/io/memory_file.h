#pragma once

#include <string>

#include "core/file/atomic_file.h"
#include "core/image/io/file_proxy.h"
#include "core/sandbox/shared_memory.h"

namespace swaplight {

/// A file in memory that a library may open by name, to be copied to the disk by who notices what fails
/// there. On systems without such files it is the temporary file itself.
class MemoryFile {
 public:
  explicit MemoryFile(const AtomicFile& file);
  [[nodiscard]] const std::string& path() const { return m_path; }
  /// The errno of what cannot be read of it; 0: all was handed over.
  [[nodiscard]] int copyTo(FileProxy& disk) const;

 private:
  OwnedDescriptor m_memory;
  std::string m_path;
};

}  // namespace swaplight
