#include "ui/camera/seen_frame.h"

#include <algorithm>
#include <utility>

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

FilterPipeline seenLook(const Document& document, const ViewerState& viewer) {
  FilterPipeline look = document.cameraLook;
  if (viewer.plain) {
    look.stages.clear();
  } else if (viewer.filterAlone && *viewer.filterAlone < look.stages.size()) {
    look.stages = {look.stages[*viewer.filterAlone]};
    look.stages.front().on = true;
  }
  return look;
}

std::optional<SeenRequest> seenRequest(const std::shared_ptr<const ColorConfig>& config,
                                       const std::shared_ptr<const LiveSet>& live, uint64_t edits,
                                       const Document& document, const ViewerState& viewer, const Rig& rig) {
  FilterPipeline look = seenLook(document, viewer);
  if (std::none_of(look.stages.begin(), look.stages.end(), [](const FilterStage& stage) { return stage.on; }))
    return std::nullopt;
  SeenRequest request = frameRequest(config, live, edits, document, rig);
  request.look = std::move(look);
  return request;
}

}  // namespace swaplight
