#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/file/temporary_names.h"

namespace swaplight {

/// A file on its way: written under a temporary name beside its target, then renamed, so that nobody ever
/// sees half a file and a failure leaves the old one as it was. Not committed, the temporary is removed.
///
///   AtomicFile file("frame.exr");
///   ... write file.temporary() ...
///   file.commit();
class AtomicFile {
 public:
  /// Throws InputError where the target cannot be written: its folder is missing or not writable, it is a
  /// folder, a device or read-only. A symbolic link is followed: the file that it names is replaced, and its
  /// owner, group and mode are the new file's, as far as this user may give them. Throws MachineError where
  /// the machine has no room.
  explicit AtomicFile(const std::filesystem::path& target);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Exists, empty; has the target's extension.
  [[nodiscard]] const std::filesystem::path& temporary() const { return m_temporary; }

  /// Flushes to the disk and renames. Throws MachineError: the disk is full, an I/O error.
  void commit();

  /// For a writer that failed: throws MachineError that names the target, and the full disk if that is why;
  /// otherwise `detail`, the writer's own words, or the system's for an errno.
  [[noreturn]] void fail(std::string_view detail) const;
  [[noreturn]] void fail(int error) const;

 private:
  std::filesystem::path m_target;  ///< as the person named it, for messages
  std::filesystem::path m_resolved;
  std::filesystem::path m_temporary;
  TemporaryName m_registered;
  bool m_committed = false;
};

/// Throws what an AtomicFile for this target would, before the work that makes it.
void checkWritable(const std::filesystem::path& target);

/// Writes the bytes, atomically. Throws InputError as AtomicFile does.
void writeFile(const std::filesystem::path& file, std::string_view bytes);

/// A whole file as bytes; a pipe that somebody writes to will do (`<(program)` of a shell). Throws InputError
/// where it is missing, a folder, a device, a pipe without a writer, unreadable or above `limit` bytes.
[[nodiscard]] std::string readFile(const std::filesystem::path& file, size_t limit);

}  // namespace swaplight
