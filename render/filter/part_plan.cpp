#include "render/filter/part_plan.h"

#include <algorithm>

namespace swaplight {
namespace {

constexpr int kSmallHalo = 64;  ///< halos that may be added up, in pixels
constexpr int kSmallestSide = 64;

/// What the textures of a part take, in the midst of the frame.
size_t bytesHeld(std::span<const PlannedStage> stages, int side, int width, int height) {
  int halo = 0;
  for (const PlannedStage& stage : stages) halo += stage.halo;
  const FilterWindow part{(width - std::min(side, width)) / 2,
                          (height - std::min(side, height)) / 2,
                          std::min(side, width),
                          std::min(side, height),
                          width,
                          height};
  size_t most = 0;
  for (const PlannedStage& stage : stages) {
    const FilterWindow input = part.grown(halo);
    halo -= stage.halo;
    most = std::max(most, stage.program->pixelsHeld(input, part.grown(halo), stage.values));
  }
  return most * FilterTexture::kBytesPerPixel;
}

/// The largest part that fits.
int sideOf(std::span<const PlannedStage> stages, int width, int height, int mostSide, size_t mostBytes) {
  int side = std::min(mostSide, std::max(width, height));
  while (side * 3 / 4 >= kSmallestSide && bytesHeld(stages, side, width, height) > mostBytes)
    side = side * 3 / 4;
  return side;
}

}  // namespace

std::vector<PartGroup> planParts(std::span<const PlannedStage> stages, int width, int height, int mostSide,
                                 size_t mostBytes) {
  const int atOnce = sideOf(stages, width, height, mostSide, mostBytes);
  if (atOnce >= std::max(width, height)) return {{0, stages.size(), atOnce}};
  std::vector<PartGroup> groups;
  int halo = 0;
  for (size_t i = 0; i < stages.size(); ++i) {
    const bool joins = halo == 0 || stages[i].halo == 0 || halo + stages[i].halo <= kSmallHalo;
    if (groups.empty() || !joins) {
      groups.push_back({i, i, 0});
      halo = 0;
    }
    halo += stages[i].halo;
    groups.back().end = i + 1;
  }
  for (PartGroup& group : groups)
    group.side =
        sideOf(stages.subspan(group.begin, group.end - group.begin), width, height, mostSide, mostBytes);
  return groups;
}

}  // namespace swaplight
