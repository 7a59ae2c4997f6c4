#include "core/export/document_export.h"

#include "core/base/error.h"
#include "core/edit/stack/beta_file.h"
#include "core/export/frame_export.h"
#include "core/export/look_export.h"
#include "core/export/provenance.h"
#include "core/file/atomic_file.h"
#include "core/report/session_report.h"
#include "core/session/open_source.h"

namespace swaplight {

void checkExport(const ColorConfig& config, const ExportRequest& request) {
  if (request.kind == ExportKind::Frame) checkFrame(config, request.file, request.frame);
  if (request.kind == ExportKind::Look && !isLookFile(request.file))
    throw InputError("{}: the global part of a look is written as .cube, .ccc or .cc", request.file.string());
  checkWritable(request.file);
}

std::vector<std::filesystem::path> exportDocument(const ColorConfig& config,
                                                  const std::shared_ptr<const SolvedSet>& set,
                                                  const Document& document, const ExportRequest& request,
                                                  const Progress& progress) {
  checkExport(config, request);
  const bool edited = document.edits != EditStack{};
  const SolvedSet withThem = edited ? withEdits(set, document.edits) : SolvedSet();
  const SolvedSet& shown = edited ? withThem : *set;
  const std::filesystem::path& file = request.file;
  switch (request.kind) {
    case ExportKind::Frame: {
      FrameOptions options = frameOptionsFor(document.display, file, request.frame);
      options.cameraLook = request.cameraLook;
      if (isSceneLinear(file)) options.write.text = provenanceOf(shown, document.rig, document.source);
      exportFrame(config, shown, document.rig, file, options, progress);
      break;
    }
    case ExportKind::Layers: {
      LayerOptions options = request.layers;
      options.text = provenanceOf(shown, document.rig, document.source);
      options.cameraLook = request.cameraLook;
      options.seenThrough = document.display;
      exportLayers(config, shown, document.rig, file, options, progress);
      break;
    }
    case ExportKind::Beta:
      progress.update(0, "writing");
      return writeBetaMaps(shown, file);
    case ExportKind::Look:
      progress.update(0, "finding what is global");
      writeLook(config, globalLook(config, shown, document.rig), document.display, file);
      break;
    case ExportKind::Report:
      progress.update(0, "drawing");
      writeFile(file, SessionReport({config, shown, document.rig, document.display,
                                     document.source.filename().string()})
                          .html());
      break;
  }
  return {file};
}

}  // namespace swaplight
