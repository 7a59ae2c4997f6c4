#include "core/view/display_table.h"

#include <algorithm>
#include <cmath>

#include "core/image/half.h"
#include "core/simd.h"
#include "core/view/false_color.h"

namespace swaplight {
namespace {

constexpr int kHalves = 65536;
constexpr size_t kBlock = ColorCube::kBlock;
constexpr uint32_t kOpaque = 0xff000000;

uint8_t byteOf(float code) {
  return static_cast<uint8_t>(std::lround(255 * std::clamp(code, 0.0F, 1.0F)));
}

SWAPLIGHT_SIMD
void scale(const float* in, float factor, float* out, size_t count) {
  for (size_t i = 0; i < count; ++i) out[i] = in[i] * factor;
}

/// Rec.709's weights, as for the grey of the channel view.
SWAPLIGHT_SIMD
void luminance(const float* r, const float* g, const float* b, float factor, float* out, size_t count) {
  const float wr = 0.2126F * factor, wg = 0.7152F * factor, wb = 0.0722F * factor;
  for (size_t i = 0; i < count; ++i) out[i] = wr * r[i] + wg * g[i] + wb * b[i];
}

/// Shows one channel, or the luma of the codes, as grey.
SWAPLIGHT_SIMD
void pickChannel(uint32_t* rgba, size_t count, uint32_t wr, uint32_t wg, uint32_t wb) {
  for (size_t i = 0; i < count; ++i) {
    const uint32_t p = rgba[i];
    const uint32_t grey = ((p & 255) * wr + (p >> 8 & 255) * wg + (p >> 16 & 255) * wb + (1 << 15)) >> 16;
    rgba[i] = kOpaque | grey | grey << 8 | grey << 16;
  }
}

void pickChannel(uint32_t* rgba, size_t count, ViewChannel channel) {
  constexpr uint32_t kOne = 1 << 16;
  switch (channel) {
    case ViewChannel::Color:
      return;
    case ViewChannel::Red:
      return pickChannel(rgba, count, kOne, 0, 0);
    case ViewChannel::Green:
      return pickChannel(rgba, count, 0, kOne, 0);
    case ViewChannel::Blue:
      return pickChannel(rgba, count, 0, 0, kOne);
    case ViewChannel::Luminance:
      return pickChannel(rgba, count, 13933, 46871, 4732);
  }
}

}  // namespace

DisplayTable::DisplayTable(std::shared_ptr<const BakedView> view, const ViewSettings& settings)
    : m_view(std::move(view)), m_exposure(std::exp2(settings.exposureStops)), m_channel(settings.channel) {
  if (settings.falseColor) {
    m_falseColors.resize(kHalves);
    for (int bits = 0; bits < kHalves; ++bits) {
      const Rgb color = falseColor(finiteHalf(bits));
      m_falseColors[static_cast<size_t>(bits)] = kOpaque | byteOf(color.r) |
                                                 static_cast<uint32_t>(byteOf(color.g)) << 8 |
                                                 static_cast<uint32_t>(byteOf(color.b)) << 16;
    }
    return;
  }
  for (int c = 0; c < 3; ++c) {
    std::vector<uint8_t>& codes = m_codes[static_cast<size_t>(c)];
    codes.resize(kHalves);
    for (int bits = 0; bits < kHalves; ++bits) {
      const auto at = static_cast<size_t>(bits);
      const float code = m_view ? m_view->curve(c)[at] : finiteHalf(bits);
      codes[at] = byteOf(settings.gamma == 1 ? code : std::pow(std::max(code, 0.0F), 1 / settings.gamma));
    }
  }
}

void DisplayTable::apply(const float* r, const float* g, const float* b, size_t count, uint32_t* rgba) const {
  alignas(64) float values[3 * kBlock];
  alignas(64) uint16_t bits[3 * kBlock];
  for (size_t begin = 0; begin < count; begin += kBlock) {
    const size_t block = std::min(kBlock, count - begin);
    uint32_t* out = rgba + begin;
    if (!m_falseColors.empty()) {
      luminance(r + begin, g + begin, b + begin, m_exposure, values, block);
      halfFromFloat(values, bits, block);
      for (size_t i = 0; i < block; ++i) out[i] = m_falseColors[bits[i]];
      continue;
    }
    scale(r + begin, m_exposure, values, block);
    scale(g + begin, m_exposure, values + kBlock, block);
    scale(b + begin, m_exposure, values + 2 * kBlock, block);
    if (m_view) m_view->mix(values, block);
    for (size_t c = 0; c < 3; ++c) halfFromFloat(values + c * kBlock, bits + c * kBlock, block);
    const uint8_t *codesR = m_codes[0].data(), *codesG = m_codes[1].data(), *codesB = m_codes[2].data();
    for (size_t i = 0; i < block; ++i)
      out[i] = kOpaque | codesR[bits[i]] | static_cast<uint32_t>(codesG[bits[kBlock + i]]) << 8 |
               static_cast<uint32_t>(codesB[bits[2 * kBlock + i]]) << 16;
    pickChannel(out, block, m_channel);
  }
}

}  // namespace swaplight
