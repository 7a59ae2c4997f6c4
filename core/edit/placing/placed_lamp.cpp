#include "core/edit/placing/placed_lamp.h"

#include <algorithm>
#include <cmath>

#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr float kLeastSoft = 1e-3F;
constexpr float kLeastSquare = static_cast<float>(LampRays::kNearest * LampRays::kNearest);

// The cosine as a lamp of some size has it. Below its horizon there is none.
SWAPLIGHT_SIMD(void, soften, (float soft, int count, float* shade), (soft, count, shade)) {
  const float scale = 1 / (4 * soft);
  for (int i = 0; i < count; ++i) {
    const float cosine = shade[i];
    const float low = std::max(cosine + soft, 0.F);
    shade[i] = cosine >= soft ? cosine : low * low * scale;
  }
}

SWAPLIGHT_SIMD(void, parallelCosines,
               (const float* nx, const float* ny, const float* nz, const float* direction, int count,
                float* cosine),
               (nx, ny, nz, direction, count, cosine)) {
  const float x = direction[0];
  const float y = direction[1];
  const float z = direction[2];
  for (int i = 0; i < count; ++i) cosine[i] = nx[i] * x + ny[i] * y + nz[i] * z;
}

// `lamp`: its place. `square`: of its distance from the middle.
SWAPLIGHT_SIMD(void, nearCosines,
               (const float* nx, const float* ny, const float* nz, const float* lamp, float x, float step,
                float y, float square, int count, float* cosine, float* level),
               (nx, ny, nz, lamp, x, step, y, square, count, cosine, level)) {
  const float wy = lamp[1] - y;
  const float wz = lamp[2];
  for (int i = 0; i < count; ++i) {
    const float wx = lamp[0] - (x + step * static_cast<float>(i));
    const float length = std::max(wx * wx + wy * wy + wz * wz, kLeastSquare);
    cosine[i] = (nx[i] * wx + ny[i] * wy + nz[i] * wz) / std::sqrt(length);
    level[i] = square / length;
  }
}

SWAPLIGHT_SIMD(void, multiply, (const float* by, int count, float* values), (by, count, values)) {
  for (int i = 0; i < count; ++i) values[i] *= by[i];
}

}  // namespace

PlacedLamp::PlacedLamp(const LampPlace& place, double diameter)
    : m_direction(LampRays({place.azimuth, place.elevation, {}, {}}).at(0, 0).direction),
      m_soft(std::max(static_cast<float>(std::sin(std::atan(diameter / 2))), kLeastSoft)) {
  if (place.distance)
    m_distance = std::max(static_cast<float>(*place.distance), static_cast<float>(LampRays::kNearest));
}

void PlacedLamp::shadeRow(const NormalRow& row, int count, float* shade) const {
  const auto& [nx, ny, nz] = row.normal;
  if (!m_distance) {
    parallelCosines(nx, ny, nz, m_direction.val, count, shade);
    return soften(m_soft, count, shade);
  }
  const cv::Vec3f lamp = m_direction * *m_distance;
  std::vector<float> level(static_cast<size_t>(count));
  nearCosines(nx, ny, nz, lamp.val, row.x, row.step, row.y, *m_distance * *m_distance, count, shade,
              level.data());
  soften(m_soft, count, shade);
  multiply(level.data(), count, shade);
}

}  // namespace swaplight
