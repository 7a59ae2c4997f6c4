#pragma once

#include "ui/tools/picture_tool.h"

namespace swaplight {

inline constexpr Tool kBrush{"brush.take", "Paint with light", "Shift+B",
                             "Paint with the selected light: more, less or softer. Escape, or its button "
                             "pressed again, leaves the brush.",
                             true};

/// Paints with the chosen light. A ring shows the brush's size, and within it where it is half as strong.
extern const PictureTool kBrushTool;

/// The brush's radius in pixels of the picture.
[[nodiscard]] float brushRadius(const EditingContext& studio);
void setBrushRadius(EditingContext& studio, float radius);

/// A light of its own without any light yet, for the brush to paint; takes the brush.
void addPaintedLight(EditingContext& studio);

/// What the brush does, as an edit without its mask.
[[nodiscard]] Edit brushEdit(const EditingContext& studio);

}  // namespace swaplight
