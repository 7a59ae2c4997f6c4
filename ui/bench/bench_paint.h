#pragma once

#include "core/base/json_fwd.h"
#include "ui/shell/studio.h"

namespace swaplight {

/// Paints 200 strokes over a picture of 3840 x 2160 with the mouse, as a person does; first as a few edits,
/// then each as an edit of its own. Returns, a case: the time from the mouse's move to the picture that shows
/// the dab, of undo and redo of every stroke (median, p95, worst, in milliseconds); how long saving took and
/// for how long it held up a frame; and the most memory held.
[[nodiscard]] Json benchPaint(const StudioOptions& options);

}  // namespace swaplight
