#include "ui/export_controller.h"

#include "core/export/frame_export.h"
#include "core/session/open_source.h"

namespace swaplight {

void ExportController::exportFrame(std::shared_ptr<const SolvedSet> set, const Document& document,
                                   const std::filesystem::path& file) {
  m_job.start(
      [set = std::move(set), document, file](const Progress& progress) {
        const bool edited = document.edits != EditStack{};
        const SolvedSet shown = edited ? withEdits(set, document.edits) : SolvedSet();
        swaplight::exportFrame(edited ? shown : *set, document.rig, file,
                               frameOptionsFor(document.display, file), progress);
        return file;
      },
      m_wake);
}

void ExportController::update(Messages& messages) {
  try {
    if (const auto file = m_job.take()) messages.info("Exported " + file->string());
  } catch (const Stopped&) {
    messages.info("Export cancelled.");
  } catch (const std::exception& error) {
    messages.error(error.what());
  }
}

}  // namespace swaplight
