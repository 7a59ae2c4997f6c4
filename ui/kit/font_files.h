#pragma once

#include <filesystem>

namespace swaplight {

// Where Debian's packages put the fonts. Without the first the second is taken, without both Dear ImGui's
// own.
inline const std::filesystem::path kInterFolder = "/usr/share/fonts/opentype/inter";
inline const std::filesystem::path kFallbackFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
inline const std::filesystem::path kIconFontFile =
    "/usr/share/fonts/truetype/material-design-icons-iconfont/MaterialIcons-Regular.ttf";

}  // namespace swaplight
