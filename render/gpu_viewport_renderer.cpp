#include "render/gpu_viewport_renderer.h"

#include "render/gl/gl_info.h"
#include "render/gl/pixel_transfer.h"

namespace swaplight {

unsigned GpuViewportRenderer::texture(const ViewportRequest& request, int place) {
  Place& here = m_places[place];
  if (here.shown == request) return here.target.texture();
  here.shown.reset();
  std::erase_if(m_pictures, [](const auto& picture) { return picture.first.expired(); });
  draw(request, here);
  here.shown = request;
  return here.target.texture();
}

void GpuViewportRenderer::draw(const ViewportRequest& request, Place& place) {
  ViewRenderer& viewerA = viewerFor(request.a.colorSpace);
  const ViewWindow onA = windowOnCopy(request.window, request.a.scale);
  if (request.comparison.mode == Comparison::Mode::Difference) {
    TiledTexture& difference = relit(place.a, differenceLayers(request.a.layers, request.b.layers));
    place.target.resize(request.window.width, request.window.height);
    viewerA.draw(difference, onA, request.settings, {.absolute = true}, place.target);
    return;
  }
  viewerA.draw(relit(place.a, request.a.layers), onA, request.settings, place.target);
  if (request.comparison.mode != Comparison::Mode::Wipe)
    place.b = {};
  else
    viewerFor(request.b.colorSpace)
        .draw(relit(place.b, request.b.layers), windowOnCopy(request.window, request.b.scale),
              request.settings, {.side = glm::vec3(sideOfB(request.comparison, request.window))},
              place.target);
}

TiledTexture& GpuViewportRenderer::relit(Frame& frame, const std::vector<ViewLayer>& layers) {
  const Pyramid& first = *layers.front().picture;
  if (frame.picture.width != first.width() || frame.picture.height != first.height())
    frame.picture = TiledTexture(first.width(), first.height(), largestTextureSide());
  else if (frame.layers == layers)
    return frame.picture;
  frame.layers.clear();
  std::vector<TextureLayer> textures;
  textures.reserve(layers.size());
  for (const ViewLayer& layer : layers) textures.push_back({&uploaded(*layer.picture), layer.factor});
  m_layers.draw(textures, frame.picture);
  frame.layers = layers;
  return frame.picture;
}

const TiledTexture& GpuViewportRenderer::uploaded(const Pyramid& picture) {
  const auto found = m_pictures.find(picture.identity());
  if (found != m_pictures.end()) return found->second;
  TiledTexture texture(picture.width(), picture.height(), largestTextureSide());
  updatePicture(texture, picture.level(0), 0, 0);
  return m_pictures.emplace(picture.identity(), std::move(texture)).first->second;
}

ViewRenderer& GpuViewportRenderer::viewerFor(const std::string& colorSpace) {
  return m_viewers.try_emplace(colorSpace, *m_config, colorSpace).first->second;
}

void GpuViewportRenderer::changed(const Pyramid& picture, const TileRect& where) {
  const auto found = m_pictures.find(picture.identity());
  if (found == m_pictures.end()) return;
  updatePicture(found->second, picture.level(0).crop(where.x, where.y, where.width, where.height), where.x,
                where.y);
  for (auto& [name, place] : m_places) {
    place.shown.reset();
    place.a.layers.clear();
    place.b.layers.clear();
  }
}

void GpuViewportRenderer::setConfig(const std::shared_ptr<const ColorConfig>& config) {
  if (m_config == config) return;
  m_viewers.clear();
  m_config = config;
  for (auto& [name, place] : m_places) place.shown.reset();
}

std::string GpuViewportRenderer::words() const {
  return "graphics card: " + glInfo().renderer;
}

}  // namespace swaplight
