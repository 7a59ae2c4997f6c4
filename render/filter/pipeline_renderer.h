#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/filter/filter_library.h"
#include "core/filter/filtered_image.h"
#include "render/filter/part_plan.h"
#include "render/filter/pipeline_memory.h"

namespace swaplight {

/// The folder with the filters that come with the program.
[[nodiscard]] std::filesystem::path builtInFilterFolder();
/// Where camera looks lie that can be named: the person's, and the program's own.
[[nodiscard]] std::vector<std::filesystem::path> installedLookFolders();
/// The person's filters, the machine's and the program's own.
[[nodiscard]] FilterLibrary installedFilters();

struct PipelineOptions {
  /// Scene-linear light to display code values 0..1, in place, on R G B. Called at most once a frame.
  std::function<void(ImageSpan)> displayFromScene;
  FilterTime time;
  int tileSide = 4096;                        ///< larger frames are drawn in parts where the filters allow it
  size_t mostTextureBytes = size_t{1} << 30;  ///< parts are smaller where they would take more
  FilterLimits limitsPerTile;
  /// Told, in a line, of each filter that cannot be drawn, which is then left out. Empty: that is an error.
  std::function<void(const std::string&)> leftOut = {};
  PipelineMemory* memory = nullptr;  ///< of this frame; nullptr: nothing is kept
};

/// Runs pipelines on pictures in the current OpenGL context, which must be the same as long as it lives.
/// Compiled filters and pictures that were read are kept.
///
/// A filter works on what its SPACE says. Scene-linear light becomes display codes by the caller's view,
/// before the first filter that wants codes. From then on the picture stays one for a display: a filter that
/// works on light is given display light (the codes, decoded by sRGB's curve), and its result is encoded
/// again.
class PipelineRenderer {
 public:
  PipelineRenderer() = default;
  PipelineRenderer(const PipelineRenderer&) = delete;
  PipelineRenderer& operator=(const PipelineRenderer&) = delete;

  /// Throws InputError that names the filter, unless it is left out: it does not compile, takes too long, its
  /// picture cannot be read, the frame is too large for one that sees it whole. ResourceError, Stopped.
  [[nodiscard]] FilteredImage apply(FilteredImage frame, std::span<const ResolvedStage> stages,
                                    const PipelineOptions& options, const Progress& progress = {});

  /// The stages whose filters compile and whose pictures can be read: before any of them changes what the
  /// picture's values mean. Of the others options.leftOut is told; without it, throws InputError.
  [[nodiscard]] std::vector<ResolvedStage> usable(std::span<const ResolvedStage> stages,
                                                  const PipelineOptions& options);
  /// Compiles a filter, or gives the one that is compiled already. Throws InputError.
  const FilterProgram& program(const std::shared_ptr<const Filter>& filter) {
    return program(filter, kindFor(*filter));
  }

 private:
  /// Plain ISF filters may read textures by coordinates of their own.
  static TextureKind kindFor(const Filter& filter) {
    return filter.builtIn ? TextureKind::Pixels : TextureKind::Coordinates;
  }
  const FilterProgram& program(const std::shared_ptr<const Filter>& filter, TextureKind kind);

  struct Run;
  static void drawParts(const Image& from, Image& to, const Run& run, const PartGroup& group,
                        const Progress& progress);
  /// `primaries`: of the light that the run works on.
  void drawRun(FilteredImage& frame, std::span<const ResolvedStage> stages, const std::string& primaries,
               const PipelineOptions& options, const Progress& progress);
  FilterPictures picturesFromFiles(const ResolvedStage& stage, const std::string& primaries);
  FilterPictures picturesOf(const ResolvedStage& stage, const Image& frame, const Image& light,
                            const std::string& primaries);
  std::shared_ptr<const FilterTexture> pictureFrom(const std::filesystem::path& file, FilterSpace space,
                                                   const std::string& primaries);

  std::map<std::pair<const Filter*, TextureKind>, std::unique_ptr<FilterProgram>> m_programs;
  std::vector<std::shared_ptr<const Filter>> m_filters;  ///< keeps the keys of m_programs alive
  /// By what the filter works on, the light's primaries, and file.
  std::map<std::array<std::string, 3>, std::shared_ptr<const FilterTexture>> m_pictures;
};

}  // namespace swaplight
