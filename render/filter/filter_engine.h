#pragma once

#include <memory>
#include <span>

#include "render/filter/pipeline_renderer.h"
#include "render/gl/gl_thread.h"

namespace swaplight {

/// Draws pipelines on a thread with an OpenGL context of its own, so that jobs, frames of a sequence and a
/// studio with a window can ask for them from any thread. Compiled filters are kept.
class FilterEngine {
 public:
  /// Throws ResourceError where there is no OpenGL.
  FilterEngine();
  FilterEngine(const FilterEngine&) = delete;
  FilterEngine& operator=(const FilterEngine&) = delete;
  ~FilterEngine();

  /// As PipelineRenderer::apply; one picture after the other. `progress` is reported to from the thread.
  [[nodiscard]] FilteredImage apply(FilteredImage frame, std::span<const ResolvedStage> stages,
                                    const PipelineOptions& options, const Progress& progress = {});
  /// The stages that can be drawn; the others are left out, or are an error, as apply() has it.
  [[nodiscard]] std::vector<ResolvedStage> usable(std::span<const ResolvedStage> stages,
                                                  const PipelineOptions& options);

 private:
  GlThread m_thread;
  std::unique_ptr<PipelineRenderer> m_renderer;
};

}  // namespace swaplight
