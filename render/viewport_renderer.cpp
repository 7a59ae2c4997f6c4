#include "render/viewport_renderer.h"

#include "render/cpu_viewport_renderer.h"
#include "render/gl/gl_info.h"
#include "render/gpu_viewport_renderer.h"

namespace swaplight {

std::unique_ptr<ViewportRenderer> makeViewportRenderer(Engine engine,
                                                       std::shared_ptr<const ColorConfig> config) {
  const bool processor = engine == Engine::Processor || (engine == Engine::Auto && glInfo().software);
  if (processor) return std::make_unique<CpuViewportRenderer>(std::move(config));
  return std::make_unique<GpuViewportRenderer>(std::move(config));
}

}  // namespace swaplight
