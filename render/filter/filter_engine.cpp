#include "render/filter/filter_engine.h"

namespace swaplight {

FilterEngine::FilterEngine() {
  m_thread.run([this] { m_renderer = std::make_unique<PipelineRenderer>(); });
}

FilterEngine::~FilterEngine() {
  m_thread.run([this] { m_renderer.reset(); });
}

FilteredImage FilterEngine::apply(FilteredImage frame, std::span<const ResolvedStage> stages,
                                  const PipelineOptions& options, const Progress& progress) {
  return m_thread.run([&] { return m_renderer->apply(std::move(frame), stages, options, progress); });
}

std::vector<ResolvedStage> FilterEngine::usable(std::span<const ResolvedStage> stages,
                                                const PipelineOptions& options) {
  return m_thread.run([&] { return m_renderer->usable(stages, options); });
}

}  // namespace swaplight
