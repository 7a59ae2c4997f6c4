#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "core/balance/lamp_reading.h"
#include "ui/control/lights_context.h"
#include "ui/jobs/job.h"

namespace swaplight {

/// Reads what the lamps of the open set are doing in another photograph of it, in a thread, and sets the
/// mixer so: one step that can be undone.
class LampReader {
 public:
  explicit LampReader(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// `set`: without edits.
  void start(std::shared_ptr<const ColorConfig> config, std::shared_ptr<const SolvedSet> set,
             const std::filesystem::path& photograph);
  /// Takes what was read, unless another set is open by now. To be called in each frame.
  void update(LightsContext& studio);
  [[nodiscard]] bool busy() const { return m_job.running(); }

 private:
  std::function<void()> m_wake;
  std::shared_ptr<const SolvedSet> m_set;  ///< that is read for
  std::string m_name;                      ///< of the photograph
  Job<LampReading> m_job;
};

}  // namespace swaplight
