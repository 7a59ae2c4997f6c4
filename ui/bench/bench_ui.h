#pragma once

#include "core/base/json_fwd.h"
#include "ui/shell/studio.h"

namespace swaplight {

/// Drags a light's slider over large pictures, as a person does, and measures every frame: from the mouse's
/// move to the picture that shows it. In a window; without a display in memory. Returns, and writes to
/// standard error as a table: frame times and input-to-picture latency (median, p95, worst, in milliseconds)
/// a case, the engine, the machine's load, the most memory held.
[[nodiscard]] Json benchUi(const StudioOptions& options);

}  // namespace swaplight
