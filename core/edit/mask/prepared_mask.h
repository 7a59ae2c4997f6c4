#pragma once

#include <vector>

#include "core/edit/mask/mask_context.h"

namespace swaplight {

/// A mask ready to be asked for rows: text, lines and pictures are drawn, shadows found.
class PreparedMask {
 public:
  /// `shadowZone`: 0 for most edits; see MaskContext::raster. Throws InputError as the context does.
  PreparedMask(const Mask& mask, MaskContext& context, int shadowZone = 0);

  /// Fills out[0..count) with the mask at the pixels x.. of row y. Returns whether any is above 0.
  bool row(int x, int y, int count, float* out) const;
  /// A shape of the mask as pixels; nullptr for a formula.
  [[nodiscard]] const MaskRaster* raster(size_t shape) const { return m_parts[shape].raster.get(); }
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
