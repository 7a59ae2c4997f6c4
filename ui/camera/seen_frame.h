#pragma once

#include <optional>

#include "core/session/document.h"
#include "ui/camera/seen_request.h"
#include "ui/state/viewer_state.h"

namespace swaplight {

/// For the interface's thread. What the set's frame follows from, with the document's camera look. `edits`:
/// EditController::revision().
[[nodiscard]] SeenRequest frameRequest(const std::shared_ptr<const ColorConfig>& config,
                                       const std::shared_ptr<const LiveSet>& live, uint64_t edits,
                                       const Document& document, const Rig& rig);

/// The document's camera look as the viewer is to show it: whole, one filter of it alone (also one that is
/// off), or none.
[[nodiscard]] FilterPipeline seenLook(const Document& document, const ViewerState& viewer);

/// What the set's frame under that look follows from; nothing where no filter of it is on.
[[nodiscard]] std::optional<SeenRequest> seenRequest(const std::shared_ptr<const ColorConfig>& config,
                                                     const std::shared_ptr<const LiveSet>& live,
                                                     uint64_t edits, const Document& document,
                                                     const ViewerState& viewer, const Rig& rig);

}  // namespace swaplight
