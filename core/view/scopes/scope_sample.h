#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/image/image.h"
#include "core/view/display/display_table.h"
#include "core/view/window_pixels.h"

namespace swaplight {

/// A rectangle of a picture, in its pixels.
struct PictureRegion {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PictureRegion&) const = default;
};

/// Pixels of a picture for its scopes: whole rows, evenly spread. Not averaged, so that clipped pixels stay
/// clipped.
struct ScopeSample {
  Image linear;                ///< R G B before the view
  std::vector<uint8_t> codes;  ///< 8-bit R G B A as shown
  [[nodiscard]] int width() const { return linear.width(); }
  [[nodiscard]] int height() const { return linear.height(); }
};

/// At most about `maxPixels` of the region, which lies inside of the picture: at least one row.
[[nodiscard]] ScopeSample scopeSample(std::span<const ViewLayer> layers, const PictureRegion& region,
                                      const DisplayTable& table, int maxPixels = 400000);

/// The same of a picture that is display codes 0..1 already; their light is what sRGB's curve makes of them,
/// in Rec.709 primaries.
[[nodiscard]] ScopeSample scopeSampleOfCodes(ImageView codes, const PictureRegion& region,
                                             int maxPixels = 400000);

}  // namespace swaplight
