#include "ui/camera/seen_frame.h"

#include <algorithm>

#include "core/relight/rig.h"

namespace swaplight {

SeenRequest frameRequest(const std::shared_ptr<const ColorConfig>& config,
                         const std::shared_ptr<const LiveSet>& live, uint64_t edits, const Document& document,
                         const Rig& rig) {
  return {config,
          live,
          edits,
          rigFactors(*config, rig, live->set().colorSpace()),
          rig.ambient,
          document.cameraLook,
          displayWithin(*config, document.display)};
}

std::optional<SeenRequest> seenRequest(const std::shared_ptr<const ColorConfig>& config,
                                       const std::shared_ptr<const LiveSet>& live, uint64_t edits,
                                       const Document& document, const Rig& rig) {
  const std::vector<FilterStage>& stages = document.cameraLook.stages;
  if (std::none_of(stages.begin(), stages.end(), [](const FilterStage& stage) { return stage.on; }))
    return std::nullopt;
  return frameRequest(config, live, edits, document, rig);
}

}  // namespace swaplight
