#include "core/solve/registration/moved_shots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/shot_place.h"

namespace swaplight {
namespace {

constexpr int kTaps = 6;

/// Lanczos weights (three lobes) of the pixels -2 .. 3 around a position 0 <= fraction < 1.
std::array<float, kTaps> lanczos(float fraction) {
  const auto sinc = [](double t) { return std::abs(t) < 1e-7 ? 1.0 : std::sin(M_PI * t) / (M_PI * t); };
  std::array<float, kTaps> weight{};
  double sum = 0;
  std::array<double, kTaps> exact{};
  for (int j = 0; j < kTaps; ++j) {
    const double t = double(fraction) - (j - 2);
    sum += exact[size_t(j)] = std::abs(t) < 3 ? sinc(t) * sinc(t / 3) : 0;
  }
  for (size_t j = 0; j < kTaps; ++j) weight[j] = float(exact[j] / sum);
  return weight;
}

/// A plane of a shot.
struct Plane {
  const float* values;
  int width, height;
  float clip;

  [[nodiscard]] int column(int u) const { return std::clamp(u, 0, width - 1); }
  [[nodiscard]] const float* line(int v) const {
    return values + size_t(std::clamp(v, 0, height - 1)) * size_t(width);
  }
  /// What the kernel may spread.
  [[nodiscard]] float bounded(float value) const { return std::isfinite(value) ? std::min(value, clip) : 0; }
  /// A value that its two by two nearest pixels cannot give is theirs: broken, saturated, or not below
  /// nothing.
  [[nodiscard]] float asNearest(float value, int left, int up) const {
    float least = INFINITY;
    for (const float* row : {line(up), line(up + 1)})
      for (const int at : {column(left), column(left + 1)}) {
        least = std::min(least, row[at]);
        if (!std::isfinite(row[at]))
          value = NAN;
        else if (row[at] >= clip)
          value = std::max(value, clip);  // NaN stays
      }
    if (least >= 0 && value < 0) return 0;
    return value;
  }
};

/// Moved by whole pixels and a fraction: across and down one after the other.
void movePlane(const Plane& in, const ShotShift& shift, float* out) {
  const int left = int(std::floor(shift.x));
  const int up = int(std::floor(shift.y));
  const auto across = lanczos(shift.x - float(left));
  const auto down = lanczos(shift.y - float(up));
  parallelRows(in.height, 32, [&](int begin, int end) {
    std::vector<float> sum(static_cast<size_t>(in.width));
    for (int v = begin; v < end; ++v) {
      std::fill(sum.begin(), sum.end(), 0.0F);
      for (int j = 0; j < kTaps; ++j) {
        const float* row = in.line(v + up + j - 2);
        for (int u = 0; u < in.width; ++u) sum[size_t(u)] += down[size_t(j)] * in.bounded(row[u]);
      }
      float* to = out + size_t(v) * size_t(in.width);
      for (int u = 0; u < in.width; ++u) {
        float value = 0;
        for (int j = 0; j < kTaps; ++j) value += across[size_t(j)] * sum[size_t(in.column(u + left + j - 2))];
        to[u] = in.asNearest(value, u + left, v + up);
      }
    }
  });
}

/// Weights at so many fractions of a pixel: as near as a hundredth of a pixel needs.
class LanczosTable {
 public:
  LanczosTable() {
    for (int j = 0; j <= kSteps; ++j) m_weights[size_t(j)] = lanczos(float(j) / kSteps);
  }
  [[nodiscard]] const std::array<float, kTaps>& at(float fraction) const {
    return m_weights[size_t(std::lround(fraction * kSteps))];
  }

 private:
  static constexpr int kSteps = 512;
  std::array<std::array<float, kTaps>, kSteps + 1> m_weights;
};

/// Turned and zoomed: every pixel has a fraction of its own.
void turnPlane(const Plane& in, const ShotShift& shift, float* out) {
  static const LanczosTable table;
  const ShotPlaces places(shift, in.width, in.height);
  parallelRows(in.height, 32, [&](int begin, int end) {
    for (int v = begin; v < end; ++v)
      for (int u = 0; u < in.width; ++u) {
        const ShotPlaces::Place place = places(float(u), float(v));
        const int left = int(std::floor(place.x)), up = int(std::floor(place.y));
        const auto& across = table.at(place.x - float(left));
        const auto& down = table.at(place.y - float(up));
        float value = 0;
        for (int j = 0; j < kTaps; ++j) {
          const float* row = in.line(up + j - 2);
          float sum = 0;
          for (int i = 0; i < kTaps; ++i) sum += across[size_t(i)] * in.bounded(row[in.column(left + i - 2)]);
          value += down[size_t(j)] * sum;
        }
        out[size_t(v) * size_t(in.width) + size_t(u)] = in.asNearest(value, left, up);
      }
  });
}

}  // namespace

CapturePixels movedShots(const CapturePixels& pixels, const std::vector<ShotShift>& shifts) {
  CapturePixels moved = withoutShots(pixels);
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    const Image& shot = pixels.shots[k];
    if (!worthMoving(shifts[k])) {
      moved.shots.push_back(shot.clone());
      continue;
    }
    Image image(shot.spec());
    for (int c = 0; c < 3; ++c) {
      const Plane plane{shot.plane(c), shot.width(), shot.height(), pixels.clipLevel[k]};
      if (shifts[k].isTurned())
        turnPlane(plane, shifts[k], image.plane(c));
      else
        movePlane(plane, shifts[k], image.plane(c));
    }
    moved.shots.push_back(std::move(image));
  }
  return moved;
}

}  // namespace swaplight
