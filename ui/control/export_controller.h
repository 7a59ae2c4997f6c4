#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/export/document_export.h"
#include "core/set/solved_set.h"
#include "ui/jobs/take_or_report.h"

namespace swaplight {

/// Writes what is exported in a thread, and says when it is there.
class ExportController {
 public:
  explicit ExportController(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// `set` without edits: they are the document's. Frames and layers are seen through the document's camera
  /// look.
  void start(std::shared_ptr<const ColorConfig> config, std::shared_ptr<const SolvedSet> set,
             const Document& document, const ExportRequest& request);
  [[nodiscard]] bool busy() const { return m_job.running(); }
  /// The file that is being written.
  [[nodiscard]] const std::string& name() const { return m_name; }
  [[nodiscard]] float fraction() const { return m_job.fraction(); }
  [[nodiscard]] std::string what() const { return m_job.what(); }
  void cancel() { m_job.cancel(); }
  [[nodiscard]] bool cancelling() const { return m_job.cancelling(); }
  /// To be called often.
  void update(Messages& messages);

 private:
  struct Exported {
    std::vector<std::filesystem::path> files;
    std::string contents;              ///< of a frame or frames, for people; empty for all else
    std::vector<std::string> leftOut;  ///< filters of the camera look that are broken, a line each
  };

  std::function<void()> m_wake;
  std::string m_name;
  Job<Exported> m_job;
};

}  // namespace swaplight
