#pragma once

#include <string>
#include <vector>

namespace swaplight {

/// The ICC profile of what a display shows, to be embedded into pictures: sRGB, Rec.709 (BT.1886: gamma 2.4)
/// or P3-D65 (gamma 2.6), by the words in the display's name. Empty for any other display, and for views that
/// are no encoding of a display (Raw, Log). The same name gives the same bytes.
[[nodiscard]] std::vector<unsigned char> iccProfileOf(const std::string& display, const std::string& view);

}  // namespace swaplight
