#include "core/edit/mask/prepared_mask.h"

#include <algorithm>

namespace swaplight {
namespace {

template <typename Shape>
constexpr bool isFormula = requires(const Shape& s) {
  s.valueAt(0.f, 0.f);
};

// Where a shape may be above 0; everything for shapes without an end.
PixelRect boundsOf(const MaskShape& mask, const MaskRaster* raster, const PixelRect& all) {
  if (mask.invert) return all;
  if (raster) return raster->bounds();
  return std::visit(
      [&](const auto& s) {
        if constexpr (requires { s.bounds(); })
          return s.bounds();
        else
          return all;
      },
      mask.shape);
}

}  // namespace

PreparedMask::PreparedMask(const Mask& mask, MaskContext& context, int shadowZone)
    : m_bounds{0, 0, context.width(), context.height()} {
  const PixelRect all = m_bounds;
  for (const MaskShape& shape : mask) {
    Part part{shape, context.raster(shape, shadowZone)};
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
            if constexpr (isFormula<std::decay_t<decltype(s)>>)
              for (int i = 0; i < count; ++i)
                own[static_cast<size_t>(i)] =
                    s.valueAt(static_cast<float>(x + i) + .5f, static_cast<float>(y) + .5f);
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
