#include "core/view/display/color_cube.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/parallel.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

// An axis counts the bits of (value + kOffset) as a float: they grow linearly within an octave.
constexpr float kOffset = 0x1p-8F;
constexpr float kVerticesPerBit = ColorCube::kVerticesPerOctave / static_cast<float>(1 << 23);
// Where the octaves of the picture end and those beyond begin, which have fewer vertices.
constexpr auto kBend = static_cast<float>((ColorCube::kHighestOctave - ColorCube::kLowestOctave) *
                                          ColorCube::kVerticesPerOctave);
constexpr auto kSlopeBeyond =
    1.0F / static_cast<float>(ColorCube::kVerticesPerOctave * ColorCube::kOctavesPerStepBeyond);
constexpr auto kLastPosition = static_cast<float>(ColorCube::kSide - 1) - 0x1p-12F;
constexpr int kStepR = 4, kStepG = kStepR * ColorCube::kSide, kStepB = kStepG * ColorCube::kSide;
constexpr int kStepAll = kStepR + kStepG + kStepB;

static_assert(kOffset == 1.0F / (1 << -ColorCube::kLowestOctave));

float valueAtVertex(int vertex) {
  const auto at = static_cast<float>(vertex);
  const float position = at < kBend ? at : kBend + (at - kBend) / kSlopeBeyond;
  const auto steps = static_cast<uint32_t>(std::lround(position / kVerticesPerBit));
  return std::bit_cast<float>(std::bit_cast<uint32_t>(kOffset) + steps) - kOffset;
}

using Float4 [[gnu::vector_size(16)]] = float;

inline Float4 vertexAt(const float* vertices, int index) {
  return *reinterpret_cast<const Float4*>(vertices + index);
}

/// A cell of the cube falls into six tetrahedra along its diagonal; a point's is told by the order of its
/// fractions: from the lowest corner along the axis with the largest fraction, then the middle one's, then
/// the smallest's. In three steps, because only the middle one (four loads a pixel) cannot be done for many
/// pixels at once.
SWAPLIGHT_SIMD(void, interpolate, (const float* vertices, const float* in, float* out, size_t count),
               (vertices, in, out, count)) {
  constexpr size_t kBlock = ColorCube::kBlock;
  alignas(64) float at[3][kBlock];
  for (size_t c = 0; c < 3; ++c)
    for (size_t i = 0; i < count; ++i) {
      const float value = in[c * kBlock + i];
      const float shifted = (value > 0 ? value : 0) + kOffset;
      const int bits = std::bit_cast<int>(shifted) - std::bit_cast<int>(kOffset);
      const float even = static_cast<float>(bits) * kVerticesPerBit;
      const float position = even < kBend ? even : kBend + (even - kBend) * kSlopeBeyond;
      at[c][i] = position < kLastPosition ? position : kLastPosition;
    }

  alignas(64) int base[kBlock], afterFirst[kBlock], beforeLast[kBlock];
  alignas(64) float weights[4][kBlock];
  for (size_t i = 0; i < count; ++i) {
    const int ir = static_cast<int>(at[0][i]), ig = static_cast<int>(at[1][i]),
              ib = static_cast<int>(at[2][i]);
    const float fr = at[0][i] - static_cast<float>(ir);
    const float fg = at[1][i] - static_cast<float>(ig);
    const float fb = at[2][i] - static_cast<float>(ib);
    const float largerRG = fr >= fg ? fr : fg, smallerRG = fr >= fg ? fg : fr;
    const float largest = largerRG >= fb ? largerRG : fb;
    const float smallest = smallerRG < fb ? smallerRG : fb;
    const float middle = fr + fg + fb - largest - smallest;
    const int stepLargerRG = fr >= fg ? kStepR : kStepG;
    const int stepSmallerRG = kStepR + kStepG - stepLargerRG;
    base[i] = ir * kStepR + ig * kStepG + ib * kStepB;
    afterFirst[i] = base[i] + (largerRG >= fb ? stepLargerRG : kStepB);
    beforeLast[i] = base[i] + kStepAll - (smallerRG < fb ? stepSmallerRG : kStepB);
    weights[0][i] = 1 - largest;
    weights[1][i] = largest - middle;
    weights[2][i] = middle - smallest;
    weights[3][i] = smallest;
  }

  alignas(64) Float4 colors[kBlock];
  for (size_t i = 0; i < count; ++i)
    colors[i] = vertexAt(vertices, base[i]) * weights[0][i] +
                vertexAt(vertices, afterFirst[i]) * weights[1][i] +
                vertexAt(vertices, beforeLast[i]) * weights[2][i] +
                vertexAt(vertices, base[i] + kStepAll) * weights[3][i];
  for (size_t i = 0; i < count; ++i) {
    out[i] = colors[i][0];
    out[kBlock + i] = colors[i][1];
    out[2 * kBlock + i] = colors[i][2];
  }
}

}  // namespace

ColorCube::ColorCube(const std::function<void(ImageSpan)>& function) {
  Image image(ImageSpec::rgb(kSide, kSide * kSide));
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < kSide; ++x) {
      image.span().at(0, x, y) = valueAtVertex(x);
      image.span().at(1, x, y) = valueAtVertex(y % kSide);
      image.span().at(2, x, y) = valueAtVertex(y / kSide);
    }
  parallelRows(image.height(), kSide,
               [&](int begin, int end) { function(image.span().crop(0, begin, kSide, end - begin)); });
  m_vertices.assign(image.pixelCount() * 4, 0);
  for (size_t p = 0; p < image.pixelCount(); ++p)
    for (int c = 0; c < 3; ++c) m_vertices[4 * p + static_cast<size_t>(c)] = image.plane(c)[p];
}

void ColorCube::apply(const float* in, float* out, size_t count) const {
  interpolate(m_vertices.data(), in, out, count);
}

}  // namespace swaplight
