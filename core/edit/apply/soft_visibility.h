#pragma once

#include "core/image/image.h"

namespace swaplight {

/// A light's visibility (one channel) with wider penumbras, which end where `silhouettes` are: one channel,
/// 0..1, of any size; 1 lets nothing over. Its edges spread as by a Gaussian of standard deviation radius / 2
/// pixels; radius >= 1. Values stay within those of `visibility`.
///
/// A recursive filter of a transformed domain (Gastal and Oliveira, "Domain Transform for Edge-Aware Image
/// and Video Processing", 2011, section 5.2.3), whose distances are 1 but over silhouettes: its time does
/// not depend on the radius.
[[nodiscard]] Image softVisibility(const Image& visibility, const Image& silhouettes, int radius);

}  // namespace swaplight
