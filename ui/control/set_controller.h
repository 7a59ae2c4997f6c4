#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/ocio/color_config.h"
#include "core/set/solved_set.h"
#include "core/solve/model/solve_options.h"
#include "ui/jobs/take_or_report.h"
#include "ui/pictures/live_set.h"

namespace swaplight {

/// A set that is open, and what the viewer needs to show it quickly.
struct OpenSet {
  std::filesystem::path source;
  std::shared_ptr<LiveSet> live;              ///< with the document's edits, where there are any
  std::shared_ptr<const SolvedSet> original;  ///< without edits; never changes
  std::shared_ptr<const SolvedSet> found;     ///< without edits, in the source's own primaries; never changes

  /// As it is shown. For the interface's thread only; other threads ask `live`.
  [[nodiscard]] const SolvedSet& solved() const { return live->set(); }
  [[nodiscard]] const ViewPictures& pictures() const { return live->pictures(); }
};

/// Reads or solves the set that the person has chosen, in a thread. The set that was open stays until the new
/// one is there.
class SetController {
 public:
  explicit SetController(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// `workingSpace`: of the set that is shown; empty: the source's own.
  void load(std::shared_ptr<const ColorConfig> config, const std::filesystem::path& source,
            const SolveOptions& options, const std::string& workingSpace);
  /// The set that is open in another working space, without edits.
  void convert(std::shared_ptr<const ColorConfig> config, const OpenSet& open,
               const std::string& workingSpace);
  void cancel() { m_job.cancel(); }
  [[nodiscard]] bool busy() const { return m_job.running(); }
  [[nodiscard]] bool cancelling() const { return m_job.cancelling(); }
  /// What goes on, in words.
  [[nodiscard]] const std::string& task() const { return m_task; }
  [[nodiscard]] float fraction() const { return m_job.fraction(); }
  [[nodiscard]] std::string what() const { return m_job.what(); }

  /// Hands the result of load() or convert() on, once, when it is there.
  template <typename OnSet>
  Taken take(Messages& messages, const OnSet& onSet) {
    return takeOrReport(m_job, messages, "these pictures", onSet);
  }

 private:
  std::function<void()> m_wake;
  std::string m_task;
  Job<OpenSet> m_job;
};

}  // namespace swaplight
