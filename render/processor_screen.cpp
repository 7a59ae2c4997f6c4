#include "render/processor_screen.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/view/zebra.h"
#include "render/gl_info.h"

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

}  // namespace

unsigned ProcessorScreen::texture(const ScreenRequest& request, int place) {
  Place& here = m_places[place];
  if (here.shown == request) return here.texture.id();
  here.shown.reset();
  draw(request, here);
  here.texture.update(request.window.width, request.window.height, here.pixels.data());
  here.shown = request;
  return here.texture.id();
}

void ProcessorScreen::draw(const ScreenRequest& request, Place& place) {
  const ViewWindow& window = request.window;
  place.pixels.resize(static_cast<size_t>(window.width) * static_cast<size_t>(window.height) * 4);
  const DisplayTable& table = tableFor(request.a.colorSpace, request.settings);
  if (request.comparison.mode == Comparison::Mode::Difference)
    windowPixels(differenceLayers(request.a.layers, request.b.layers), window, absoluteCodesThrough(table),
                 place.pixels.data(), &place.sumA);
  else
    windowPixels(request.a.layers, window, codesThrough(table), place.pixels.data(), &place.sumA);
  if (request.comparison.mode == Comparison::Mode::Wipe) drawB(request, place);
  if (request.settings.zebra.on && !request.settings.falseColor)
    drawZebra(request.settings.zebra, window.width, window.height, place.pixels.data());
}

void ProcessorScreen::drawB(const ScreenRequest& request, Place& place) {
  // Only the columns that B has in some row are computed.
  const ViewWindow& window = request.window;
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
  std::vector<uint8_t> pixels(static_cast<size_t>(part.width) * static_cast<size_t>(part.height) * 4);
  windowPixels(request.b.layers, part, codesThrough(tableFor(request.b.colorSpace, request.settings)),
               pixels.data(), &place.sumB);
  for (int y = 0; y < window.height; ++y) {
    const auto [begin, end] = columnsOfB(side, y, window.width);
    if (begin >= end) continue;
    const uint8_t* from = pixels.data() + 4 * (static_cast<ptrdiff_t>(y) * part.width + begin - left);
    std::copy_n(from, 4 * (end - begin),
                place.pixels.data() + 4 * (static_cast<ptrdiff_t>(y) * window.width + begin));
  }
}

const DisplayTable& ProcessorScreen::tableFor(const std::string& colorSpace, const ViewSettings& settings) {
  const auto found = m_tables.find(colorSpace);
  if (found != m_tables.end()) {
    found->second.change(settings);
    return found->second;
  }
  if (colorSpace.empty()) return m_tables.try_emplace(colorSpace, nullptr, settings).first->second;
  return m_tables.try_emplace(colorSpace, *m_config, colorSpace, settings).first->second;
}

void ProcessorScreen::changed(const Pyramid& /*picture*/, const TileRect& /*where*/) {
  forget();
}

void ProcessorScreen::setConfig(const ColorConfig& config) {
  if (m_config == &config) return;
  m_config = &config;
  m_tables.clear();
  forget();
}

void ProcessorScreen::forget() {
  for (auto& [name, place] : m_places) {
    place.shown.reset();
    place.sumA.forget();
    place.sumB.forget();
  }
}

std::string ProcessorScreen::words() const {
  return fmt::format("processor, {} threads (OpenGL: {})", threadCount(), glInfo().renderer);
}

}  // namespace swaplight
