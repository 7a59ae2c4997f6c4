#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/session/document.h"
#include "core/solve/solved_set.h"
#include "ui/job.h"
#include "ui/messages.h"

namespace swaplight {

/// Writes frames in a thread, and says when they are there.
class ExportController {
 public:
  explicit ExportController(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// `set` without edits: they are the document's.
  void exportFrame(std::shared_ptr<const SolvedSet> set, const Document& document,
                   const std::filesystem::path& file);
  [[nodiscard]] bool busy() const { return m_job.running(); }
  /// To be called often.
  void update(Messages& messages);

 private:
  std::function<void()> m_wake;
  Job<std::filesystem::path> m_job;
};

}  // namespace swaplight
