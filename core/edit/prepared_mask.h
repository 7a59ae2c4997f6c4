#pragma once

#include <functional>
#include <vector>

#include "core/edit/mask.h"
#include "core/shadow/light_shadows.h"

namespace swaplight {

/// Finds a light's shadows on the set as solved; may take long the first time. Throws InputError for a name
/// that is not a light of the set.
using ShadowSource = std::function<std::shared_ptr<const LightShadows>(const std::string& light)>;

/// A mask ready to be asked for rows: text, lines and pictures are drawn, shadows found.
class PreparedMask {
 public:
  /// Throws InputError: a picture that cannot be read, a light without shadows.
  PreparedMask(const Mask& mask, int width, int height, const ShadowSource& shadows);

  /// Fills out[0..count) with the mask at the pixels x.. of row y. Returns whether any is above 0.
  bool row(int x, int y, int count, float* out) const;
  /// Where the mask may be above 0.
  [[nodiscard]] const PixelRect& bounds() const { return m_bounds; }
  /// The same in parts: around what is painted or drawn, many small ones.
  [[nodiscard]] std::vector<PixelRect> areas() const;
  /// Whether the mask may be above 0 somewhere in the area.
  [[nodiscard]] bool touches(const PixelRect& area) const;

 private:
  struct Part {
    MaskShape shape;
    std::shared_ptr<const MaskRaster> raster;  // of shapes that were drawn
  };
  std::vector<Part> m_parts;
  PixelRect m_bounds;
};

}  // namespace swaplight
