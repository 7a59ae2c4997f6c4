#include "core/edit/mask/prepared_mask.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swaplight {
namespace {

// 1 inside, 0 outside, smooth over `feather` pixels around a distance of 0 (outside is positive).
float coverage(float distance, float feather) {
  return std::clamp(.5f - distance / std::max(feather, 1.f), 0.f, 1.f);
}

// std::hypot guards against overflow that pictures cannot reach, and is slow.
float length(float x, float y) {
  return std::sqrt(x * x + y * y);
}

float smooth(float t) {
  t = std::clamp(t, 0.f, 1.f);
  return t * t * (3 - 2 * t);
}

float valueAt(const RectangleShape& s, float x, float y) {
  const float dx = std::max(s.x - x, x - (s.x + s.width));
  const float dy = std::max(s.y - y, y - (s.y + s.height));
  const float outside = length(std::max(dx, 0.f), std::max(dy, 0.f));
  return coverage(outside + std::min(std::max(dx, dy), 0.f), s.feather);
}

// The distance is exact for circles, and good near the rim of ellipses.
float valueAt(const EllipseShape& s, float x, float y) {
  const float u = (x - s.x) / s.radiusX;
  const float v = (y - s.y) / s.radiusY;
  const float r = length(u, v);
  const float slope = length(u / s.radiusX, v / s.radiusY);
  const float distance = slope > 0 ? r * (r - 1) / slope : -std::min(s.radiusX, s.radiusY);
  return coverage(distance, s.feather);
}

float valueAt(const LinearGradientShape& s, float x, float y) {
  const float dx = s.x1 - s.x0;
  const float dy = s.y1 - s.y0;
  const float length2 = dx * dx + dy * dy;
  return length2 > 0 ? smooth(1 - ((x - s.x0) * dx + (y - s.y0) * dy) / length2) : 1;
}

float valueAt(const RadialGradientShape& s, float x, float y) {
  const float r = length(x - s.x, y - s.y);
  return s.outer > s.inner ? smooth((s.outer - r) / (s.outer - s.inner)) : r <= s.inner;
}

float valueAt(const PatternShape& s, float x, float y) {
  const float angle = s.angle * std::numbers::pi_v<float> / 180;
  const float u = (x * std::cos(angle) - y * std::sin(angle)) / s.size;
  const float v = (x * std::sin(angle) + y * std::cos(angle)) / s.size;
  const float fu = u - std::floor(u);
  const float fv = v - std::floor(v);
  // Distances in repeats from the middle of the covered part.
  const float du = std::abs(fu - .5f) - s.cover / 2;
  const float dv = std::abs(fv - .5f) - s.cover / 2;
  switch (s.kind) {
    case PatternShape::Kind::Stripes:
      return coverage(du * s.size, s.feather);
    case PatternShape::Kind::Dots:
      return coverage((length(fu - .5f, fv - .5f) - s.cover / 2) * s.size, s.feather);
    case PatternShape::Kind::Checks: {
      const float a = coverage(du * s.size, s.feather);
      const float b = coverage(dv * s.size, s.feather);
      return a * b + (1 - a) * (1 - b);
    }
  }
  return 0;
}

template <typename Shape>
constexpr bool isDrawn = !requires(const Shape& s) {
  valueAt(s, 0.f, 0.f);
};

// A circle around what a soft shape covers; everything for shapes without an end.
PixelRect boundsOf(const MaskShape& mask, const MaskRaster* raster, const PixelRect& all) {
  if (mask.invert) return all;
  if (raster) return raster->bounds();
  const auto box = [](float x0, float y0, float x1, float y1, float feather) {
    const float air = std::max(feather, 1.f) / 2 + 1;
    const int left = static_cast<int>(std::floor(x0 - air));
    const int top = static_cast<int>(std::floor(y0 - air));
    return PixelRect{left, top, static_cast<int>(std::ceil(x1 + air)) - left,
                     static_cast<int>(std::ceil(y1 + air)) - top};
  };
  if (const auto* s = std::get_if<RectangleShape>(&mask.shape))
    return box(s->x, s->y, s->x + s->width, s->y + s->height, s->feather);
  if (const auto* s = std::get_if<RadialGradientShape>(&mask.shape)) {
    const float r = std::max(s->inner, s->outer);
    return box(s->x - r, s->y - r, s->x + r, s->y + r, 0);
  }
  if (const auto* s = std::get_if<EllipseShape>(&mask.shape))  // a soft thin ellipse reaches far: be generous
    return box(
        s->x - s->radiusX, s->y - s->radiusY, s->x + s->radiusX, s->y + s->radiusY,
        s->feather * std::max(s->radiusX, s->radiusY) / std::max(std::min(s->radiusX, s->radiusY), 1.f));
  return all;
}

}  // namespace

PreparedMask::PreparedMask(const Mask& mask, MaskGround& ground, int shadowZone)
    : m_bounds{0, 0, ground.width(), ground.height()} {
  const PixelRect all = m_bounds;
  for (const MaskShape& shape : mask) {
    Part part{shape, ground.raster(shape, shadowZone)};
    m_bounds = intersection(m_bounds, boundsOf(shape, part.raster.get(), all));
    m_parts.push_back(std::move(part));
  }
}

std::vector<PixelRect> PreparedMask::areas() const {
  for (const Part& part : m_parts) {
    if (!part.raster || part.shape.invert) continue;
    std::vector<PixelRect> tiles = part.raster->filledTiles();
    for (PixelRect& tile : tiles) tile = intersection(tile, m_bounds);
    return tiles;
  }
  return {m_bounds};
}

bool PreparedMask::touches(const PixelRect& area) const {
  if (intersection(area, m_bounds).empty()) return false;
  return std::all_of(m_parts.begin(), m_parts.end(), [&](const Part& part) {
    return !part.raster || part.shape.invert || part.raster->touches(area);
  });
}

bool PreparedMask::row(int x, int y, int count, float* out) const {
  std::fill_n(out, count, 1.f);
  thread_local std::vector<float> own;
  for (const Part& part : m_parts) {
    const bool invert = part.shape.invert;
    if (part.raster && !invert) {
      part.raster->multiplyRow(x, y, count, out);
      continue;
    }
    own.resize(static_cast<size_t>(count));
    if (part.raster) {
      std::fill(own.begin(), own.end(), 1.f);
      part.raster->multiplyRow(x, y, count, own.data());
    } else {
      std::visit(
          [&](const auto& s) {
            if constexpr (!isDrawn<std::decay_t<decltype(s)>>)
              for (int i = 0; i < count; ++i)
                own[static_cast<size_t>(i)] =
                    valueAt(s, static_cast<float>(x + i) + .5f, static_cast<float>(y) + .5f);
          },
          part.shape.shape);
    }
    for (int i = 0; i < count; ++i) {
      const float m = own[static_cast<size_t>(i)];
      out[i] *= invert ? 1 - m : m;
    }
  }
  return std::any_of(out, out + count, [](float m) { return m > 0; });
}

}  // namespace swaplight
