#include "ui/control/export_controller.h"

#include "core/export/frame_export.h"
#include "render/filter/camera_look.h"

namespace swaplight {
namespace {

/// Null where there is nothing to draw.
std::shared_ptr<CameraLook> readyLook(const FilterPipeline& look) {
  if (look.stages.empty()) return nullptr;
  CameraLookOptions options;
  options.leftOut = [](const std::string&) {};  // it is asked for afterwards
  return std::make_shared<CameraLook>(look, installedFilters(), "camera look " + look.name, options);
}

/// What is in a frame; empty where something else is exported.
std::string contentsOf(const ColorConfig& config, const Document& document, const ExportRequest& request) {
  if (request.kind != ExportKind::Frame && request.kind != ExportKind::Sequence) return {};
  return frameContents(config, request.file, frameOptionsFor(document.display, request.file, request.frame));
}

}  // namespace

void ExportController::start(std::shared_ptr<const ColorConfig> config, std::shared_ptr<const SolvedSet> set,
                             const Document& document, const ExportRequest& request) {
  m_name = request.file.filename().string();
  m_job.start(
      [config = std::move(config), set = std::move(set), document,
       request = request](const Progress& progress) mutable -> Exported {
        const std::shared_ptr<CameraLook> look =
            hasPictures(request.kind) && request.seesLook ? readyLook(document.cameraLook) : nullptr;
        request.cameraLook = look;
        request.versionLook = readyLook;
        std::vector<std::filesystem::path> files = exportDocument(*config, set, document, request, progress);
        return {std::move(files), contentsOf(*config, document, request),
                look ? look->leftOut() : std::vector<std::string>{}};
      },
      m_wake);
}

void ExportController::update(Messages& messages) {
  const Taken taken = takeOrReport(m_job, messages, "this export", [&](const Exported& exported) {
    std::string words = "Exported " + exported.files.front().string();
    if (exported.files.size() > 1) words += " and " + std::to_string(exported.files.size() - 1) + " more";
    if (!exported.contents.empty()) words += ", " + exported.contents;
    messages.info(words);
    for (const std::string& line : exported.leftOut) messages.warn("Left out of the camera look: " + line);
  });
  if (taken == Taken::Stopped) messages.info("Export cancelled.");
}

}  // namespace swaplight
