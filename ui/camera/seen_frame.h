#pragma once

#include <optional>

#include "core/session/document.h"
#include "ui/camera/seen_request.h"

namespace swaplight {

/// For the interface's thread. What the set's frame follows from, with the document's camera look. `edits`:
/// EditController::revision().
[[nodiscard]] SeenRequest frameRequest(const std::shared_ptr<const ColorConfig>& config,
                                       const std::shared_ptr<const LiveSet>& live, uint64_t edits,
                                       const Document& document, const Rig& rig);

/// What the set's frame under the document's camera look follows from; nothing where no filter of it is on.
[[nodiscard]] std::optional<SeenRequest> seenRequest(const std::shared_ptr<const ColorConfig>& config,
                                                     const std::shared_ptr<const LiveSet>& live,
                                                     uint64_t edits, const Document& document,
                                                     const Rig& rig);

}  // namespace swaplight
