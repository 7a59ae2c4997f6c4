#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/cue/cue_timeline.h"
#include "core/export/frame_file.h"
#include "core/export/layer_export.h"
#include "core/session/document.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// What is made of an open session.
enum class ExportKind {
  Frame,     ///< the relit picture
  Layers,    ///< every light as a layer of an EXR
  Beta,      ///< the lights' proportions for an image editor
  Look,      ///< what of the lighting is the same for every pixel: .cube, .ccc
  Report,    ///< a page that prints
  Sequence,  ///< the cue list as numbered frames
  Sheet,     ///< looks and versions as a contact sheet
};

/// Whether it is made of pictures that a camera look can be put on.
[[nodiscard]] constexpr bool hasPictures(ExportKind kind) {
  return kind == ExportKind::Frame || kind == ExportKind::Layers || kind == ExportKind::Sequence;
}

struct ExportRequest {
  ExportKind kind = ExportKind::Frame;
  std::filesystem::path file;
  FrameOptions frame;   ///< Frame, Sequence; where nothing is asked for the document's view
  LayerOptions layers;  ///< Layers; its text is filled in
  CueTiming timing;     ///< Sequence; its file is a pattern, as name.####.exr
  /// Report, Sheet: draws the camera looks of versions; without it they are plain.
  std::function<std::shared_ptr<FrameFilter>(const FilterPipeline&)> versionLook = {};
  bool seesGrade = true;  ///< the document's grade is put on where frames leave it
  bool seesLook = true;   ///< Frame, Layers, Sequence: the document's camera look is put on, where it has one
  /// Draws the document's camera look; null where it has none, or it is not asked for.
  std::shared_ptr<FrameFilter> cameraLook = {};
};

/// The files that an export of this name writes: beta maps as PNG are several; of a sequence, whose length
/// the timing says, the first one.
[[nodiscard]] std::vector<std::filesystem::path> exportedFiles(const Document& document, ExportKind kind,
                                                               const std::filesystem::path& file);

/// Says what is wrong before the work. Throws InputError.
void checkExport(const ColorConfig& config, const ExportRequest& request);

/// Writes it as the command line does of the saved session. `set` is without the document's edits. Gives the
/// files that were written. Throws InputError; Stopped.
std::vector<std::filesystem::path> exportDocument(const ColorConfig& config,
                                                  const std::shared_ptr<const SolvedSet>& set,
                                                  const Document& document, const ExportRequest& request,
                                                  const Progress& progress = {});

}  // namespace swaplight
