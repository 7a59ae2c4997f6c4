#include "core/view/display/baked_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/base/parallel.h"
#include "core/color/srgb.h"
#include "core/image/half.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kHalfCodes = 65536;
constexpr int kPositiveHalves = 0x7c00;
constexpr float kTolerance = 0.25F / 255;

/// The view of every half float as a grey, a curve a channel.
std::array<std::vector<float>, 3> curvesOfGreys(const ViewFunction& view) {
  constexpr int kRow = 256;
  Image greys(ImageSpec::rgb(kRow, kHalfCodes / kRow));
  for (int c = 0; c < 3; ++c)
    for (int bits = 0; bits < kHalfCodes; ++bits) greys.plane(c)[bits] = finiteHalf(bits);
  parallelRows(greys.height(), 32,
               [&](int begin, int end) { view(greys.span().crop(0, begin, kRow, end - begin)); });
  std::array<std::vector<float>, 3> curves;
  for (int c = 0; c < 3; ++c)
    curves[static_cast<size_t>(c)].assign(greys.plane(c), greys.plane(c) + kHalfCodes);
  return curves;
}

/// The value at which a rising curve reaches a code.
float valueAtCode(const std::vector<float>& curve, float code) {
  const auto end = curve.begin() + kPositiveHalves;
  const auto above = std::lower_bound(curve.begin(), end, code);
  if (above == curve.begin() || above == end) return 0;
  const auto bits = static_cast<int>(above - curve.begin());
  const float low = *(above - 1), high = *above;
  const float fraction = high > low ? (code - low) / (high - low) : 0;
  return finiteHalf(bits - 1) + fraction * (finiteHalf(bits) - finiteHalf(bits - 1));
}

/// The matrix that a view applies before its curves, if that is all it does: what grey and a little more of
/// one channel do to each channel. Rows add up to 1, because the curves are those of greys.
glm::mat3 matrixBefore(const ViewFunction& view, const std::array<std::vector<float>, 3>& curves) {
  constexpr float kGrey = 0.25F, kMore = 0.25F;
  Image probes(ImageSpec::rgb(3, 1), kGrey);
  for (int c = 0; c < 3; ++c) probes.plane(c)[c] += kMore;
  view(probes.span());
  glm::mat3 matrix(0);
  for (int out = 0; out < 3; ++out) {
    float sum = 0;
    for (int in = 0; in < 3; ++in) {
      const float value = valueAtCode(curves[static_cast<size_t>(out)], probes.plane(out)[in]);
      matrix[in][out] = (value - kGrey) / kMore;
      sum += matrix[in][out];
    }
    matrix[out][out] += 1 - sum;
  }
  return matrix;
}

/// True where matrix and curves give what the view gives, on greys, pastels and saturated colours.
bool explains(const glm::mat3& matrix, const std::array<std::vector<float>, 3>& curves,
              const ViewFunction& view) {
  constexpr int kColors = 2048;
  Image colors(ImageSpec::rgb(kColors, 1));
  Image expected(ImageSpec::rgb(kColors, 1));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> stops(-12, 4), level(0, 1);
  for (int i = 0; i < kColors; ++i) {
    glm::vec3 color(0);
    const float strength = std::exp2(stops(random));
    for (int c = 0; c < 3; ++c) {
      color[c] = (i >> c & 9) == 0 ? 0 : strength * level(random);
      colors.plane(c)[i] = color[c];
    }
    const glm::vec3 mixed = matrix * color;
    for (int c = 0; c < 3; ++c) {
      uint16_t half = 0;
      halfFromFloat(&mixed[c], &half, 1);
      expected.plane(c)[i] = curves[static_cast<size_t>(c)][half];
    }
  }
  view(colors.span());
  // A half float may be off by 2^-12 of its value, which steep curves show.
  constexpr float kRounding = 0.1F / 255;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < kColors; ++i) {
      const float a = std::clamp(colors.plane(c)[i], 0.0F, 1.0F);
      const float b = std::clamp(expected.plane(c)[i], 0.0F, 1.0F);
      if (!(std::abs(a - b) < kTolerance + kRounding)) return false;
    }
  return true;
}

SWAPLIGHT_SIMD(void, applyMatrix, (const float* matrix, float* r, float* g, float* b, size_t count),
               (matrix, r, g, b, count)) {
  for (size_t i = 0; i < count; ++i) {
    const float x = r[i], y = g[i], z = b[i];
    r[i] = matrix[0] * x + matrix[3] * y + matrix[6] * z;
    g[i] = matrix[1] * x + matrix[4] * y + matrix[7] * z;
    b[i] = matrix[2] * x + matrix[5] * y + matrix[8] * z;
  }
}

/// How code values are made from what is interpolated: by a power, or as sRGB (0).
struct Encoding {
  float power = 0;
  [[nodiscard]] float decoded(float code) const {
    return power > 0 ? std::copysign(std::pow(std::abs(code), power), code) : linearFromSrgb(code);
  }
  [[nodiscard]] float encoded(float light) const {
    return power > 0 ? std::copysign(std::pow(std::abs(light), 1 / power), light) : srgbFromLinear(light);
  }
};

/// The encoding under which a view's colours half way between two neighbouring vertices of a cube are most
/// nearly the mean of theirs: that of the display, mostly. Decided by random colours.
Encoding fittingEncoding(const ViewFunction& view) {
  constexpr int kPairs = 2048;
  constexpr std::array<Encoding, 4> kEncodings = {{{0}, {2.0F}, {2.4F}, {2.6F}}};
  constexpr float kOffset = 0x1p-8F;  // of the cube's axes
  Image colors(ImageSpec::rgb(kPairs, 3));
  std::mt19937 random(1);
  const auto level = [&] { return static_cast<float>(random() >> 8) * 0x1p-24F; };
  for (int i = 0; i < kPairs; ++i) {
    const float strength = std::exp2(14 * level() - 11), saturation = level();
    for (int c = 0; c < 3; ++c) {
      const float from = strength * (1 - saturation * level());
      const float step = random() % 2 == 0 ? 1 : std::exp2(1.0F / ColorCube::kVerticesPerOctave);
      colors.span().at(c, i, 0) = from;
      colors.span().at(c, i, 1) = (from + kOffset) * std::sqrt(step) - kOffset;
      colors.span().at(c, i, 2) = (from + kOffset) * step - kOffset;
    }
  }
  view(colors.span());
  const auto errorUnder = [&](const Encoding& encoding) {
    double error = 0;
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < kPairs; ++i) {
        const auto at = [&](int row) { return colors.span().at(c, i, row); };
        const float mean = (encoding.decoded(at(0)) + encoding.decoded(at(2))) / 2;
        const float off = std::clamp(encoding.encoded(mean), 0.0F, 1.0F) - std::clamp(at(1), 0.0F, 1.0F);
        error += static_cast<double>(off) * off;
      }
    return error;
  };
  return *std::min_element(kEncodings.begin(), kEncodings.end(), [&](const Encoding& a, const Encoding& b) {
    return errorUnder(a) < errorUnder(b);
  });
}

}  // namespace

float finiteHalf(int bits) {
  const auto half = static_cast<uint16_t>(bits);
  float value = 0;
  floatFromHalf(&half, &value, 1);
  if (std::isnan(value)) return 0;
  return std::clamp(value, -65504.0F, 65504.0F);
}

BakedView::BakedView(const ViewFunction& view) : m_curves(curvesOfGreys(view)) {
  if (explains(m_matrix, m_curves, view)) return;
  m_matrix = matrixBefore(view, m_curves);
  m_mixes = true;
  if (explains(m_matrix, m_curves, view)) return;
  const Encoding encoding = fittingEncoding(view);
  m_cube = ColorCube([&](ImageSpan vertices) {
    view(vertices);
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < vertices.height; ++y)
        // Decoded, so that what is interpolated is nearly linear in light.
        std::transform(vertices.row(c, y), vertices.row(c, y) + vertices.width, vertices.row(c, y),
                       [&](float code) { return encoding.decoded(code); });
  });
  for (std::vector<float>& curve : m_curves)
    for (int bits = 0; bits < kHalfCodes; ++bits)
      curve[static_cast<size_t>(bits)] = encoding.encoded(finiteHalf(bits));
}

void BakedView::mix(float* rgb, size_t count) const {
  if (!m_cube.empty())
    m_cube.apply(rgb, rgb, count);
  else if (m_mixes)
    applyMatrix(&m_matrix[0][0], rgb, rgb + ColorCube::kBlock, rgb + 2 * ColorCube::kBlock, count);
}

}  // namespace swaplight
