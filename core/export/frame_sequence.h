#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/export/frame_export.h"
#include "core/relight/rig.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// What is needed to make one frame.
struct FrameInput {
  std::shared_ptr<const SolvedSet> set;
  Rig rig;
  std::map<std::string, std::string> text;     ///< for the header
  std::shared_ptr<const CarriedData> carried;  ///< instead of the set's
};

struct SequenceOptions {
  std::vector<int> frames;
  std::string output;  ///< a pattern: see frameName
  FrameOptions frame;
  int workers = 2;            ///< frames made at a time
  bool skipExisting = false;  ///< a frame whose file is there is left as it is
  bool goOn = false;          ///< after a frame that failed; else no further frame is begun
};

struct FrameOutcome {
  enum class State { Written, Skipped, Failed };
  int frame = 0;
  std::filesystem::path file;
  State state = State::Written;
  std::string error;     ///< why it failed
  bool machine = false;  ///< because the machine could not: a full disk, no open files
};

struct SequenceSummary {
  std::vector<FrameOutcome> outcomes;  ///< by the order of the frames; those never begun are not there
  double seconds = 0;
  double inputShare = 0;  ///< of the workers' time: reading and solving
  double writeShare = 0;  ///< compressing and writing
  [[nodiscard]] int count(FrameOutcome::State state) const;
};

/// Throws InputError where a frame would replace one of `inputs`, or where the first one cannot be written.
void checkFrameFiles(const std::string& output, std::span<const int> frames,
                     std::span<const std::filesystem::path> inputs);

/// Makes the frames, several at a time; each is the same whatever the number of workers, and is there whole
/// or not at all. `input` is called from several threads. `done` is told of each frame, one call at a time.
/// Throws Stopped when asked to; what fails a frame is kept in its outcome.
[[nodiscard]] SequenceSummary exportSequence(const ColorConfig& config, const SequenceOptions& options,
                                             const std::function<FrameInput(int frame)>& input,
                                             const std::function<void(const FrameOutcome&)>& done,
                                             const Progress& progress = {});

}  // namespace swaplight
