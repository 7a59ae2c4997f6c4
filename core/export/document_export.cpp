#include "core/export/document_export.h"

#include "core/base/error.h"
#include "core/edit/stack/beta_file.h"
#include "core/export/cue_frames.h"
#include "core/export/frame_export.h"
#include "core/export/frame_sequence.h"
#include "core/export/look_export.h"
#include "core/export/provenance.h"
#include "core/file/atomic_file.h"
#include "core/file/frame_range.h"
#include "core/file/same_file.h"
#include "core/report/contact_sheet.h"
#include "core/report/session_report.h"
#include "core/session/open_source.h"

namespace swaplight {

namespace {

/// Says which frame failed and why; the others before it are there.
std::vector<std::filesystem::path> writtenFrames(const SequenceSummary& summary) {
  std::vector<std::filesystem::path> files;
  for (const FrameOutcome& outcome : summary.outcomes) {
    if (outcome.state == FrameOutcome::State::Failed)
      throw InputError("frame {}: {}", outcome.frame, outcome.error);
    files.push_back(outcome.file);
  }
  return files;
}

std::vector<std::filesystem::path> exportCues(const ColorConfig& config,
                                              const std::shared_ptr<const SolvedSet>& set,
                                              const Document& document, const ExportRequest& request,
                                              const Progress& progress) {
  progress.update(0, "preparing the cues");
  const CueFrames frames(set, document, request.timing, isSceneLinear(request.file));
  SequenceOptions options;
  options.output = request.file.string();
  options.frame = frameOptionsFor(document.display, request.file, request.frame);
  options.frame.cameraLook = request.cameraLook;
  for (int f = frames.timeline().firstFrame(); f <= frames.timeline().lastFrame(); ++f)
    options.frames.push_back(f);
  checkFrameFiles(options.output, options.frames, filesOfDocument(document));
  return writtenFrames(exportSequence(
      config, options, [&](int frame) { return frames.at(frame); }, [](const FrameOutcome&) {}, progress));
}

std::vector<GalleryPicture> versionsOf(const ColorConfig& config, const std::shared_ptr<const SolvedSet>& set,
                                       const Document& document, const ExportRequest& request,
                                       const Progress& progress) {
  GalleryOptions options;
  options.cameraLook = request.versionLook;
  return galleryPictures(config, set, document, options, progress);
}

}  // namespace

std::vector<std::filesystem::path> exportedFiles(const Document& document, ExportKind kind,
                                                 const std::filesystem::path& file) {
  if (kind == ExportKind::Sequence) return {frameName(file.string(), CueTiming{}.firstFrame)};
  if (kind != ExportKind::Beta) return {file};
  std::vector<std::string> lights;
  for (const LightSetting& light : document.rig.lights) lights.push_back(light.light);
  return betaMapFiles(file, lights);
}

void checkExport(const ColorConfig& config, const ExportRequest& request) {
  const bool sequence = request.kind == ExportKind::Sequence;
  if (request.kind == ExportKind::Frame || sequence) checkFrame(config, request.file, request.frame);
  if (sequence && !hasFrameNumber(request.file.string()))
    throw InputError("{}: has no place for the frame's number; write name.####.exr", request.file.string());
  if (sequence && request.frame.tone)
    throw InputError(
        "{}: a tone mapping looks at each frame by itself, so that a sequence would flicker; take a view",
        request.file.string());
  if (request.kind == ExportKind::Look && !isLookFile(request.file))
    throw InputError("{}: the global part of a look is written as .cube, .ccc or .cc", request.file.string());
  if (request.kind == ExportKind::Sheet) checkSheetFile(request.file);
  checkWritable(request.file);
}

std::vector<std::filesystem::path> exportDocument(const ColorConfig& config,
                                                  const std::shared_ptr<const SolvedSet>& set,
                                                  const Document& document, const ExportRequest& request,
                                                  const Progress& progress) {
  checkExport(config, request);
  if (!request.seesGrade && document.display.grade) {
    Document plain = document;
    plain.display.grade.reset();
    return exportDocument(config, set, plain, request, progress);
  }
  if (request.kind == ExportKind::Sequence) return exportCues(config, set, document, request, progress);
  checkOutputs(exportedFiles(document, request.kind, request.file), filesOfDocument(document));
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
      options.seenThrough = document.display.withoutGrade();  // the lights leave ungraded
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
                                     document.source.filename().string(),
                                     versionsOf(config, set, document, request, progress)})
                          .html());
      break;
    case ExportKind::Sheet:
      writeCodes(contactSheet(versionsOf(config, set, document, request, progress),
                              document.source.parent_path().filename().string()),
                 file, {}, {});
      break;
    case ExportKind::Sequence:
      break;  // above: its edits are the cues'
  }
  return {file};
}

}  // namespace swaplight
