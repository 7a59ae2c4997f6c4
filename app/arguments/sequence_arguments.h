#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/arguments/lighting_arguments.h"
#include "core/export/frame_file.h"

namespace swaplight {

/// The options that make a sequence of frames out of one command, and the command itself.
class SequenceArguments {
 public:
  void addTo(CLI::App& verb);
  /// True where the command line asks for frames.
  [[nodiscard]] bool given() const { return !m_frames.empty(); }

  /// Makes the frames. The exit code: 0, 1 where some failed, 2 where none could be made. Throws InputError.
  [[nodiscard]] int run(const ColorConfig& config, const LightingArguments& lighting,
                        const std::optional<Session>& session, const std::string& output,
                        const FrameOptions& frame, Terminal& terminal) const;

 private:
  [[nodiscard]] std::vector<int> frames() const;

  std::string m_frames;
  bool m_goOn = false;
  bool m_skipExisting = false;
  int m_workers = 2;
  std::optional<int> m_index, m_count;
};

}  // namespace swaplight
