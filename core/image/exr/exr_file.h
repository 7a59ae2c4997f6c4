#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/file/atomic_file.h"
#include "core/image/image_parts.h"

namespace swaplight {

/// OpenEXR files with ZIP or ZIPS compression in scan lines, which is what nearly every file is: packed and
/// unpacked on all threads, by libdeflate. Everything else goes through OpenImageIO.

/// True where writeExrZip can write `contents`.
[[nodiscard]] bool isExrZip(const FileToWrite& contents);

/// Writes into file.temporary(). The same contents give the same bytes. Throws InputError where it cannot be
/// written.
void writeExrZip(const FileToWrite& contents, const AtomicFile& file, const Progress& progress);

/// Reads parts whose compression allows it.
class ExrZipReader {
 public:
  /// Never throws: a file that cannot be opened has no part that can be read.
  explicit ExrZipReader(const std::filesystem::path& file);
  ExrZipReader(const ExrZipReader&) = delete;
  ExrZipReader& operator=(const ExrZipReader&) = delete;
  ~ExrZipReader();

  /// True where `read` can read the part: ZIP or ZIPS, scan lines, no subsampling, exactly these channels (in
  /// any order) and this size.
  [[nodiscard]] bool canRead(int part, const std::vector<std::string>& channels, int width, int height) const;

  /// How readRows gives such a part's rows: the types of its channels in the file's order, and for each of
  /// them its place in `channels`.
  void layout(int part, const std::vector<std::string>& channels, std::vector<PixelType>& types,
              std::vector<int>& places) const;

  /// Unpacks rows y .. y + rows of a part, where y is a multiple of 16: each row's channels one after the
  /// other. Throws InputError where it is damaged.
  void readRows(int part, int y, int rows, std::byte* to) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

}  // namespace swaplight
