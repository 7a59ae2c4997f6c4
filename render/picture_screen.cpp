#include "render/picture_screen.h"

#include "render/gl/gl_info.h"
#include "render/graphics_screen.h"
#include "render/processor_screen.h"

namespace swaplight {

std::unique_ptr<PictureScreen> makePictureScreen(Engine engine, std::shared_ptr<const ColorConfig> config) {
  const bool processor = engine == Engine::Processor || (engine == Engine::Auto && glInfo().software);
  if (processor) return std::make_unique<ProcessorScreen>(std::move(config));
  return std::make_unique<GraphicsScreen>(std::move(config));
}

}  // namespace swaplight
