#pragma once

#include <array>
#include <memory>

#include "core/image/image.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// What a brush that follows edges looks at: the set at unit white in stops, averaged over 3 x 3 pixels.
class EdgeGuide {
 public:
  explicit EdgeGuide(const SolvedSet& set);
  /// The same of a set that is shared: isOf() knows it again.
  explicit EdgeGuide(const std::shared_ptr<const SolvedSet>& set);

  [[nodiscard]] int width() const { return m_stops.width(); }
  [[nodiscard]] int height() const { return m_stops.height(); }
  /// Whether it was made of this very set, which then is still there.
  [[nodiscard]] bool isOf(const SolvedSet& set) const { return m_set.lock().get() == &set; }

  /// The surface under the middle of a brush: R, G and B by their median and their spread, in stops.
  struct Surface {
    std::array<float, 3> middle, inverseSpread;
  };
  /// Of the pixels within `radius` of a point, which is moved into the picture.
  [[nodiscard]] Surface surfaceAt(float x, float y, float radius) const;

  /// How far a pixel of the picture is of that surface, 0..1: 1 up to three times the spread (99.7 % of a
  /// surface whose pixels vary at random), 0 from five times on.
  [[nodiscard]] float likeness(const Surface& surface, int x, int y) const;

 private:
  Image m_stops;
  std::weak_ptr<const SolvedSet> m_set;
};

}  // namespace swaplight
