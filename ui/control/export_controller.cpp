#include "ui/control/export_controller.h"

namespace swaplight {

void ExportController::start(std::shared_ptr<const ColorConfig> config, std::shared_ptr<const SolvedSet> set,
                             const Document& document, const ExportRequest& request) {
  m_name = request.file.filename().string();
  m_job.start(
      [config = std::move(config), set = std::move(set), document, request](const Progress& progress) {
        return exportDocument(*config, set, document, request, progress);
      },
      m_wake);
}

void ExportController::update(Messages& messages) {
  using Files = std::vector<std::filesystem::path>;
  const Taken taken = takeOrReport(m_job, messages, "this export", [&](const Files& files) {
    std::string words = "Exported " + files.front().string();
    if (files.size() > 1) words += " and " + std::to_string(files.size() - 1) + " more";
    messages.info(words);
  });
  if (taken == Taken::Stopped) messages.info("Export cancelled.");
}

}  // namespace swaplight
