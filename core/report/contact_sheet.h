#pragma once

#include <string>
#include <vector>

#include "core/report/gallery_pictures.h"

namespace swaplight {

/// The pictures in rows, each with its number, name and note below it, under a title; display code values
/// 0..1 on dark grey. `columns`: 0 chooses as many as make the sheet about as wide as a screen. A note has at
/// most three lines; then it ends in three dots. Throws InputError where there are no pictures.
[[nodiscard]] Image contactSheet(const std::vector<GalleryPicture>& pictures, const std::string& title,
                                 int columns = 0);

/// `text` in lines of at most `width` pixels at a height of letters, broken between words; what does not fit
/// into `most` lines ends in three dots.
[[nodiscard]] std::vector<std::string> wrappedText(const std::string& text, int width, int height,
                                                   size_t most);

}  // namespace swaplight
