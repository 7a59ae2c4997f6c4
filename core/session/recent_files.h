#pragma once

#include <filesystem>
#include <vector>

namespace swaplight {

/// What was opened last, newest first; kept in a small JSON file. A list that cannot be read is an empty one.
class RecentFiles {
 public:
  static constexpr size_t kLimit = 12;

  explicit RecentFiles(std::filesystem::path file);
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return m_files; }
  /// Puts a file first and writes the list; a list that cannot be written is no reason to stop anybody.
  void add(const std::filesystem::path& file);
  void clear();

 private:
  void write() const;

  std::filesystem::path m_list;
  std::vector<std::filesystem::path> m_files;
};

}  // namespace swaplight
