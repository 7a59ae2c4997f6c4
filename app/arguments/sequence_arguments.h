#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments/lighting_arguments.h"
#include "core/cue/cue_timeline.h"
#include "core/export/frame_file.h"
#include "core/export/frame_sequence.h"

namespace swaplight {

/// Frames a second, and how long cues are held that nothing follows.
void addTimingOptions(CLI::App& verb, CueTiming& timing);

/// The options that make a sequence of frames out of one command, and the command itself.
class SequenceArguments {
 public:
  void addTo(CLI::App& verb);
  /// True where the command line asks for frames.
  [[nodiscard]] bool given() const { return m_cues || m_framesGiven; }
  /// Throws InputError where options say how frames are made and none are asked for (a file that was to be
  /// skipped would be replaced), or how cues are played and none are.
  void check() const;

  /// Makes the frames: of the range, or of the session's cue list. The exit code: 0, 1 where some failed, 2
  /// where none could be made. Throws InputError.
  [[nodiscard]] int run(const ColorConfig& config, const LightingArguments& lighting,
                        const std::optional<Session>& session, const std::string& output,
                        const FrameOptions& frame, Terminal& terminal) const;

 private:
  [[nodiscard]] std::vector<int> share(const std::vector<int>& all) const;
  /// With the time code that --timecode-frame asks for.
  [[nodiscard]] FrameInput timed(FrameInput input, int frame) const;
  [[nodiscard]] int runFrames(const ColorConfig& config, const std::vector<int>& all,
                              const std::function<FrameInput(int)>& input, const std::string& output,
                              const FrameOptions& frame, Terminal& terminal) const;
  [[nodiscard]] int runCues(const ColorConfig& config, const LightingArguments& lighting,
                            const std::optional<Session>& session, const std::string& output,
                            const FrameOptions& frame, Terminal& terminal) const;

  std::string m_frames;
  bool m_framesGiven = false;  ///< an empty range, of a shell's variable, is a mistake, and no still
  bool m_cues = false;
  CueTiming m_timing;
  std::vector<const CLI::Option*> m_timingOptions, m_frameOptions;
  bool m_goOn = false;
  bool m_skipExisting = false;
  int m_workers = 2;
  std::optional<int> m_index, m_count;
  std::optional<int> m_timecodeFrame;
};

}  // namespace swaplight
