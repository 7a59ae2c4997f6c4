#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/program/terminal.h"
#include "core/image/images_in_files.h"

namespace swaplight {

/// How much of a verb's pictures may lie in memory.
class MemoryArguments {
 public:
  void addTo(CLI::App& verb);
  /// Where it was said: as long as what is returned lives, large pictures lie in temporary files beside
  /// `output`. Else null: all lies in memory, and what is too large for that is refused. Warns where that
  /// folder is memory, too.
  [[nodiscard]] std::unique_ptr<const ImagesInFiles> filesBeside(const std::filesystem::path& output,
                                                                 Terminal& terminal) const;

 private:
  double m_gigabytes = 0;  ///< GiB; 0: not said
};

}  // namespace swaplight
