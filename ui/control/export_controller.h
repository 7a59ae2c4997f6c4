#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/export/document_export.h"
#include "core/set/solved_set.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"

namespace swaplight {

/// Writes what is exported in a thread, and says when it is there.
class ExportController {
 public:
  explicit ExportController(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// `set` without edits: they are the document's.
  void start(std::shared_ptr<const SolvedSet> set, const Document& document, const ExportRequest& request);
  [[nodiscard]] bool busy() const { return m_job.running(); }
  /// Shows how far it is, and a way to stop it, in the lower right corner of a rectangle of the screen.
  void drawProgress(float right, float bottom);
  /// To be called often.
  void update(Messages& messages);

 private:
  std::function<void()> m_wake;
  std::string m_name;  ///< of the file that is being written
  Job<std::vector<std::filesystem::path>> m_job;
};

}  // namespace swaplight
