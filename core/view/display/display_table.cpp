#include "core/view/display/display_table.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/image/half.h"
#include "core/simd/simd.h"
#include "core/view/display/exact_view.h"
#include "core/view/display/false_color.h"

namespace swaplight {
namespace {

constexpr int kHalves = 65536;
constexpr size_t kBlock = ColorCube::kBlock;
constexpr uint32_t kOpaque = 0xff000000;

uint8_t byteOf(float code) {
  return static_cast<uint8_t>(std::lround(255 * std::clamp(code, 0.0F, 1.0F)));
}

/// Infinities become the largest half float, because a view's matrix would make NaN of them; NaN becomes 0.
SWAPLIGHT_SIMD(void, expose, (const float* in, float factor, float* out, size_t count),
               (in, factor, out, count)) {
  constexpr float kLargest = 65504;
  for (size_t i = 0; i < count; ++i) {
    const float value = in[i] * factor;
    const float bounded = value < kLargest ? (value > -kLargest ? value : -kLargest) : kLargest;
    out[i] = value == value ? bounded : 0;
  }
}

SWAPLIGHT_SIMD(void, weightedSum,
               (const float* r, const float* g, const float* b, const float* weights, float* out,
                size_t count),
               (r, g, b, weights, out, count)) {
  const float wr = weights[0], wg = weights[1], wb = weights[2];
  for (size_t i = 0; i < count; ++i) out[i] = wr * r[i] + wg * g[i] + wb * b[i];
}

/// Shows one channel, or the luma of the codes, as grey. Weights add up to 2^16.
SWAPLIGHT_SIMD(void, mixToGrey, (uint32_t * rgba, size_t count, uint32_t wr, uint32_t wg, uint32_t wb),
               (rgba, count, wr, wg, wb)) {
  for (size_t i = 0; i < count; ++i) {
    const uint32_t p = rgba[i];
    const uint32_t grey = ((p & 255) * wr + (p >> 8 & 255) * wg + (p >> 16 & 255) * wb + (1U << 15)) >> 16;
    rgba[i] = kOpaque | grey | grey << 8 | grey << 16;
  }
}

void pickChannel(uint32_t* rgba, size_t count, ViewChannel channel) {
  constexpr uint32_t kOne = 1 << 16;
  switch (channel) {
    case ViewChannel::Color:
      return;
    case ViewChannel::Red:
      return mixToGrey(rgba, count, kOne, 0, 0);
    case ViewChannel::Green:
      return mixToGrey(rgba, count, 0, kOne, 0);
    case ViewChannel::Blue:
      return mixToGrey(rgba, count, 0, 0, kOne);
    case ViewChannel::Luminance:
      return mixToGrey(rgba, count, 13933, 46871, 4732);
  }
}

std::shared_ptr<const BakedView> bake(const ColorConfig& config, const std::string& colorSpace,
                                      const ViewSettings& settings) {
  return std::make_shared<const BakedView>(exactView(config, colorSpace, settings.display));
}

}  // namespace

DisplayTable::DisplayTable(std::shared_ptr<const BakedView> view, const ViewSettings& settings,
                           const Rgb& luminanceWeights)
    : m_view(std::move(view)), m_luminanceWeights(luminanceWeights), m_settings(settings) {
  change(settings);
}

DisplayTable::DisplayTable(const ColorConfig& config, std::string colorSpace, const ViewSettings& settings)
    : m_config(&config),
      m_colorSpace(std::move(colorSpace)),
      m_view(bake(config, m_colorSpace, settings)),
      m_luminanceWeights(luminanceWeights(config, m_colorSpace)),
      m_settings(settings) {
  change(settings);
}

void DisplayTable::change(const ViewSettings& settings) {
  if (m_config && settings.display != m_settings.display) m_view = bake(*m_config, m_colorSpace, settings);
  m_settings = settings;
  m_exposure = std::exp2(settings.exposureStops);
  m_falseColors.clear();
  if (settings.falseColor) {
    m_falseColors.resize(kHalves);
    for (int bits = 0; bits < kHalves; ++bits) {
      const Rgb color = falseColor(finiteHalf(bits));
      const uint32_t r = byteOf(color.r), g = byteOf(color.g), b = byteOf(color.b);
      m_falseColors[static_cast<size_t>(bits)] = kOpaque | r | g << 8 | b << 16;
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

void DisplayTable::apply(const float* r, const float* g, const float* b, int count, uint8_t* rgba) const {
  alignas(64) float values[3 * kBlock];
  alignas(64) uint16_t bits[3 * kBlock];
  alignas(64) uint32_t pixels[kBlock];
  const Rgb weights = m_luminanceWeights * m_exposure;
  const uint8_t *codesR = m_codes[0].data(), *codesG = m_codes[1].data(), *codesB = m_codes[2].data();
  for (size_t begin = 0; begin < static_cast<size_t>(count); begin += kBlock) {
    const size_t block = std::min(kBlock, static_cast<size_t>(count) - begin);
    if (!m_falseColors.empty()) {
      weightedSum(r + begin, g + begin, b + begin, &weights[0], values, block);
      halfFromFloat(values, bits, block);
      for (size_t i = 0; i < block; ++i) pixels[i] = m_falseColors[bits[i]];
    } else {
      expose(r + begin, m_exposure, values, block);
      expose(g + begin, m_exposure, values + kBlock, block);
      expose(b + begin, m_exposure, values + 2 * kBlock, block);
      if (m_view) m_view->mix(values, block);
      for (size_t c = 0; c < 3; ++c) halfFromFloat(values + c * kBlock, bits + c * kBlock, block);
      for (size_t i = 0; i < block; ++i)
        pixels[i] = kOpaque | codesR[bits[i]] | static_cast<uint32_t>(codesG[bits[kBlock + i]]) << 8 |
                    static_cast<uint32_t>(codesB[bits[2 * kBlock + i]]) << 16;
      pickChannel(pixels, block, m_settings.channel);
    }
    std::memcpy(rgba + 4 * begin, pixels, 4 * block);
  }
}

}  // namespace swaplight
