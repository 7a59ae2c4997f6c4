#pragma once

#include <filesystem>
#include <vector>

#include "core/relight/rig.h"

namespace swaplight {

/// The light colours that a person has kept, and those that were used last, newest first; in a small JSON
/// file, as texts that applySetting reads. A file that cannot be read is an empty one; one that cannot be
/// written is no reason to stop anybody.
class Swatches {
 public:
  static constexpr size_t kMostKept = 24, kMostRecent = 12;

  explicit Swatches(std::filesystem::path file);
  [[nodiscard]] const std::vector<LightColor>& kept() const { return m_kept; }
  /// Without those that are kept, and without white.
  [[nodiscard]] const std::vector<LightColor>& recent() const { return m_recent; }
  /// Puts a colour first. The oldest goes where there are too many.
  void keep(const LightColor& color);
  void drop(const LightColor& color);
  /// Remembers a colour that a light has been given.
  void use(const LightColor& color);

 private:
  void write() const;

  std::filesystem::path m_file;
  std::vector<LightColor> m_kept, m_recent;
};

}  // namespace swaplight
