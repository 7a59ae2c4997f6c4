#pragma once

#include <optional>

#include "core/image/image.h"
#include "core/image/pixel_rect.h"

namespace swaplight {

/// The part of the photographs that counts, and how much smaller they are made.
struct CaptureFrame {
  std::optional<PixelRect> crop;  ///< pixels of the files; nothing: all of them
  double scale = 1;               ///< of what is left, 0.02..1
  [[nodiscard]] bool isWhole() const { return !crop && scale == 1; }
  bool operator==(const CaptureFrame&) const = default;
};

/// "100,50,1200,800". Throws InputError.
[[nodiscard]] PixelRect cropFromText(const std::string& text);
/// A scale within its range. Throws InputError.
[[nodiscard]] double checkedScale(double scale);

/// The image made smaller by averaging in linear light. Where one of the pixels that are averaged reaches
/// `clip`, the result does, too: nothing saturated gets lost in an average.
[[nodiscard]] Image scaledImage(const Image& image, double scale, float clip);

}  // namespace swaplight
