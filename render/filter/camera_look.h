#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "core/filter/filter_library.h"
#include "core/filter/frame_filter.h"
#include "render/filter/filter_engine.h"

namespace swaplight {

/// What a camera look is drawn with.
struct CameraLookOptions {
  double framesPerSecond = 24;
  int tileSide = 4096;             ///< larger frames are drawn in parts, see PipelineOptions
  double mostSecondsPerTile = 20;  ///< for one filter that is not the program's own
  /// Told, in a line and once, of each filter that is broken: it is then left out, and the others are drawn.
  /// Called from any thread. Empty: a broken filter is an error.
  std::function<void(const std::string&)> leftOut = {};
};

/// A pipeline that is ready to be drawn on frames: the one way by which `look apply`, `relight`, `export` and
/// the studio put a camera look on a picture.
class CameraLook : public FrameFilter {
 public:
  /// Finds and compiles the filters that are on. `where` begins messages. Throws InputError: a filter is
  /// broken (or, where those are left out, all of them are); ResourceError where there is no OpenGL.
  CameraLook(FilterPipeline pipeline, const FilterLibrary& library, const std::string& where,
             const CameraLookOptions& options = {});

  [[nodiscard]] FilteredImage apply(FilteredImage frame,
                                    const std::function<void(ImageSpan)>& displayFromScene, int frameNumber,
                                    const Progress& progress = {}) override;
  [[nodiscard]] const FilterPipeline& pipeline() const override { return m_pipeline; }
  [[nodiscard]] bool wantsLight() const override { return swaplight::wantsLight(m_stages); }

  /// The filters that are drawn, in their order.
  [[nodiscard]] const std::vector<ResolvedStage>& stages() const { return m_stages; }
  /// What was left out so far, a line each.
  [[nodiscard]] std::vector<std::string> leftOut() const;
  /// Every file that is read: filters of their own and pictures.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;

 private:
  void leaveOut(const std::string& line);
  [[noreturn]] void failAll(const std::string& line) const;

  FilterPipeline m_pipeline;
  std::string m_where;
  CameraLookOptions m_options;
  std::vector<ResolvedStage> m_stages;
  std::unique_ptr<FilterEngine> m_engine;  ///< none where there is nothing to draw
  mutable std::mutex m_mutex;              ///< of what follows
  std::set<std::string> m_leftOut;
};

}  // namespace swaplight
