#include "ui/control/export_controller.h"

#include "core/base/error.h"

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
  try {
    const auto files = m_job.take();
    if (!files) return;
    std::string words = "Exported " + files->front().string();
    if (files->size() > 1) words += " and " + std::to_string(files->size() - 1) + " more";
    messages.info(words);
  } catch (const Stopped&) {
    messages.info("Export cancelled.");
  } catch (const std::bad_alloc&) {
    messages.error("There is not enough memory for this export.");
  } catch (const std::exception& error) {
    messages.error(error.what());
  }
}

}  // namespace swaplight
