#include "render/cpu_viewport_renderer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/view/display/zebra.h"
#include "render/gl/gl_info.h"

namespace swaplight {
namespace {

RowCodes codesThrough(const DisplayTable& table) {
  return [&table](const float* r, const float* g, const float* b, int count, uint8_t* rgba) {
    table.apply(r, g, b, count, rgba);
  };
}

/// The size of a difference, through the table.
RowCodes absoluteCodesThrough(const DisplayTable& table) {
  return [&table](const float* r, const float* g, const float* b, int count, uint8_t* rgba) {
    constexpr int kBlock = 512;
    std::array<std::array<float, kBlock>, 3> sizes;
    for (int begin = 0; begin < count; begin += kBlock) {
      const int block = std::min(kBlock, count - begin);
      const std::array<const float*, 3> channels{r + begin, g + begin, b + begin};
      for (size_t c = 0; c < 3; ++c)
        std::transform(channels[c], channels[c] + block, sizes[c].begin(),
                       [](float v) { return std::abs(v); });
      table.apply(sizes[0].data(), sizes[1].data(), sizes[2].data(), block,
                  rgba + 4 * static_cast<ptrdiff_t>(begin));
    }
  };
}

bool hasZebra(const ViewSettings& settings) {
  return settings.zebra.on && !settings.falseColor;
}

bool shows(const LayeredPicture& shown, const Pyramid& picture) {
  return std::any_of(shown.layers.begin(), shown.layers.end(), [&](const ViewLayer& layer) {
    return isSamePicture(layer.identity, picture.identity());
  });
}

/// The pixels of a window in which a part of the picture counts: with what interpolation and the halves of
/// the picture reach around it.
PixelRect windowPart(const ViewWindow& window, const PixelRect& picture) {
  const int reach = 2 << nearestLevel(window.zoom);
  const PixelRect grown = picture.grown(reach);
  const auto low = [](double at) { return static_cast<int>(std::floor(std::clamp(at, -1e6, 1e6))); };
  const int left = low(window.windowX(grown.x));
  const int top = low(window.windowY(grown.y));
  return intersection({left, top, low(window.windowX(grown.right())) + 1 - left,
                       low(window.windowY(grown.bottom())) + 1 - top},
                      {0, 0, window.width, window.height});
}

}  // namespace

unsigned CpuViewportRenderer::texture(const ViewportRequest& request, int place) {
  Place& here = m_places[place];
  if (here.shown == request) {
    here.shown = request;  // the pictures may have been moved
    if (!here.changed.empty()) drawChanged(here);
    return here.texture.id();
  }
  here.shown.reset();
  drawAll(request, here);
  here.shown = request;
  return here.texture.id();
}

void CpuViewportRenderer::drawAll(const ViewportRequest& request, Place& place) {
  const ViewWindow& window = request.window;
  place.pixels.resize(static_cast<size_t>(window.width) * static_cast<size_t>(window.height) * 4);
  draw(request, window, &place, place.pixels.data());
  if (hasZebra(request.settings))
    drawZebra(request.settings.zebra, window.width, window.height, place.pixels.data());
  place.texture.update(window.width, window.height, place.pixels.data());
  place.changed = {};
}

void CpuViewportRenderer::drawChanged(Place& place) {
  const ViewWindow& window = place.shown->window;
  const PixelRect part = windowPart(window, std::exchange(place.changed, {}));
  if (part.empty()) return;
  if (part.width == window.width && part.height == window.height) return drawAll(*place.shown, place);
  ViewWindow small = window;
  small.left = window.pictureX(part.x);
  small.top = window.pictureY(part.y);
  small.width = part.width;
  small.height = part.height;
  std::vector<uint8_t> pixels(static_cast<size_t>(part.width) * static_cast<size_t>(part.height) * 4);
  draw(*place.shown, small, nullptr, pixels.data());
  for (int y = 0; y < part.height; ++y)
    std::copy_n(pixels.data() + 4 * static_cast<ptrdiff_t>(y) * part.width, 4 * part.width,
                place.pixels.data() + 4 * (static_cast<ptrdiff_t>(part.y + y) * window.width + part.x));
  place.texture.updatePart(part.x, part.y, part.width, part.height, place.pixels.data());
}

void CpuViewportRenderer::draw(const ViewportRequest& request, const ViewWindow& window, Place* place,
                               uint8_t* pixels) {
  const DisplayTable& table = tableFor(request.a.colorSpace, request.settings);
  LayerSum* sum = place ? &place->sumA : nullptr;
  const ViewWindow onA = windowOnCopy(window, request.a.scale);
  if (request.comparison.mode == Comparison::Mode::Difference)
    windowPixels(differenceLayers(request.a.layers, request.b.layers), onA, absoluteCodesThrough(table),
                 pixels, sum);
  else
    windowPixels(request.a.layers, onA, codesThrough(table), pixels, sum);
  if (request.comparison.mode == Comparison::Mode::Wipe)
    drawB(request, window, place ? &place->sumB : nullptr, pixels);
}

void CpuViewportRenderer::drawB(const ViewportRequest& request, const ViewWindow& window, LayerSum* sum,
                                uint8_t* pixels) {
  // Only the columns that B has in some row are computed.
  const glm::dvec3 side = sideOfB(request.comparison, window);
  int left = window.width, right = 0;
  for (int y = 0; y < window.height; ++y) {
    const auto [begin, end] = columnsOfB(side, y, window.width);
    if (begin >= end) continue;
    left = std::min(left, begin);
    right = std::max(right, end);
  }
  if (left >= right) return;
  ViewWindow part = window;
  part.left = window.pictureX(left);
  part.width = right - left;
  std::vector<uint8_t> own(static_cast<size_t>(part.width) * static_cast<size_t>(part.height) * 4);
  windowPixels(request.b.layers, windowOnCopy(part, request.b.scale),
               codesThrough(tableFor(request.b.colorSpace, request.settings)), own.data(), sum);
  for (int y = 0; y < window.height; ++y) {
    const auto [begin, end] = columnsOfB(side, y, window.width);
    if (begin >= end) continue;
    const uint8_t* from = own.data() + 4 * (static_cast<ptrdiff_t>(y) * part.width + begin - left);
    std::copy_n(from, 4 * (end - begin), pixels + 4 * (static_cast<ptrdiff_t>(y) * window.width + begin));
  }
}

const DisplayTable& CpuViewportRenderer::tableFor(const std::string& colorSpace,
                                                  const ViewSettings& settings) {
  const auto found = m_tables.find(colorSpace);
  if (found != m_tables.end()) {
    found->second.change(settings);
    return found->second;
  }
  if (colorSpace.empty()) return m_tables.try_emplace(colorSpace, nullptr, settings).first->second;
  return m_tables.try_emplace(colorSpace, *m_config, colorSpace, settings).first->second;
}

void CpuViewportRenderer::changed(const Pyramid& picture, const TileRect& where) {
  for (auto& [name, place] : m_places) {
    place.sumA.pixelsChanged(picture);
    place.sumB.pixelsChanged(picture);
    if (!place.shown || !(shows(place.shown->a, picture) || shows(place.shown->b, picture))) continue;
    const bool all = where.width >= picture.width() && where.height >= picture.height();
    if (all || hasZebra(place.shown->settings))  // stripes are drawn over the pixels
      place.shown.reset();
    else
      place.changed = enclosing(place.changed, {where.x, where.y, where.width, where.height});
  }
}

void CpuViewportRenderer::setConfig(const std::shared_ptr<const ColorConfig>& config) {
  if (m_config == config) return;
  m_tables.clear();
  m_config = config;
  for (auto& [name, place] : m_places) place.shown.reset();
}

std::string CpuViewportRenderer::words() const {
  return fmt::format("processor, {} threads (OpenGL: {})", threadCount(), glInfo().renderer);
}

}  // namespace swaplight
