#pragma once

#include <memory>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/edit/raster/mask_raster.h"

namespace swaplight {

class EdgeGuide;

/// Where the brush was; x and y in pixels of the picture (a pixel's centre lies at .5), pressure 0..1.
struct StrokePoint {
  float x = 0, y = 0, pressure = 1;
  bool operator==(const StrokePoint&) const = default;
};

/// One gesture of the brush.
struct Stroke {
  float radius = 40;     ///< pixels, > 0; the brush ends there
  float hardness = .5f;  ///< 0 falls off from the centre, 1 is a disk with an edge of one pixel
  float flow = .5f;      ///< what one dab adds of what is missing to `opacity`, 0..1
  float opacity = 1;     ///< what the stroke builds up to, never beyond, 0..1
  bool erase = false;    ///< takes away instead
  bool pressureToRadius = false;
  bool pressureToFlow = true;
  bool edges = false;  ///< paints only what is like the surface under the middle of the brush
  std::vector<StrokePoint> points;
  bool operator==(const Stroke&) const = default;
};

/// What has been painted: the strokes, and the mask that they make. Dabs lie at even distances along the path
/// (a quarter of the radius), whatever the rate at which its points arrived. Copies share their tiles.
/// Strokes that follow edges need the set's picture: without a guide they are painted as if they did not.
class Painting {
 public:
  Painting() = default;
  Painting(int width, int height) : m_mask(width, height) {}
  /// With a guide of the same size; nullptr: none.
  Painting(int width, int height, std::shared_ptr<const EdgeGuide> guide)
      : m_mask(width, height), m_guide(std::move(guide)) {}
  /// The same strokes, painted again by another guide.
  [[nodiscard]] Painting guidedBy(std::shared_ptr<const EdgeGuide> guide) const;

  /// Starts a stroke with its points, if it has any.
  void begin(Stroke stroke);
  /// Continues the last stroke. Returns what changed.
  PixelRect add(const StrokePoint& point);

  [[nodiscard]] const std::vector<std::shared_ptr<const Stroke>>& strokes() const { return m_strokes; }
  [[nodiscard]] const MaskRaster& mask() const { return m_mask; }
  /// Whether a stroke follows edges.
  [[nodiscard]] bool followsEdges() const;
  [[nodiscard]] const std::shared_ptr<const EdgeGuide>& guide() const { return m_guide; }

 private:
  PixelRect dab(const StrokePoint& at);
  PixelRect follow(const StrokePoint& from, const StrokePoint& to);

  std::vector<std::shared_ptr<const Stroke>> m_strokes;
  MaskRaster m_mask;
  std::shared_ptr<const EdgeGuide> m_guide;
  float m_toNextDab = 0;  // along the path, from the last point
};

[[nodiscard]] Json jsonFromStroke(const Stroke& stroke);
/// Throws InputError.
[[nodiscard]] Stroke strokeFromJson(const Json& json, const std::string& where);

}  // namespace swaplight
