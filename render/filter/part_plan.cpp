#include "render/filter/part_plan.h"

#include <algorithm>

namespace swaplight {
namespace {

constexpr int kSmallHalo = 64;  ///< halos that may be added up, in pixels
constexpr int kSmallestSide = 64;

using Stages = std::span<const PlannedStage>;

/// The part in the midst of the frame: no other has more of its halo.
FilterWindow partInMidst(const PartGroup& group, int width, int height) {
  const int across = std::min(group.side, width), up = std::min(group.side, height);
  return {(width - across) / 2, (height - up) / 2, across, up, width, height};
}

/// What the textures of a part take.
size_t bytesHeld(Stages stages, const PartGroup& group, int width, int height) {
  const FilterWindow part = partInMidst(group, width, height);
  int halo = group.halo;
  size_t most = 0;
  for (const PlannedStage& stage : stages.subspan(group.begin, group.end - group.begin)) {
    const FilterWindow input = part.grown(halo);
    halo -= stage.halo;
    most = std::max(most, stage.program->pixelsHeld(input, part.grown(halo), stage.values));
  }
  return most * FilterTexture::kBytesPerPixel;
}

bool isTooWide(const PartGroup& group, int width, int height, const PartLimits& limits) {
  const FilterWindow input = largestInput(group, width, height);
  return std::max(input.width, input.height) > limits.textureSide;
}

void setSide(PartGroup& group, Stages stages, int width, int height, const PartLimits& limits) {
  group.side = std::min(limits.side, std::max(width, height));
  const auto shrinkWhile = [&](const auto& tooLarge, int least) {
    while (group.side * 3 / 4 >= least && tooLarge()) group.side = group.side * 3 / 4;
  };
  shrinkWhile([&] { return isTooWide(group, width, height, limits); }, kSmallestSide);
  shrinkWhile([&] { return bytesHeld(stages, group, width, height) > limits.textureBytes; },
              std::max(kSmallestSide, group.halo * 3 / 4));
}

/// Filters that look far by themselves, with those that look at their own pixel alone.
std::vector<PartGroup> groupsOf(Stages stages) {
  std::vector<PartGroup> groups;
  for (size_t i = 0; i < stages.size(); ++i) {
    const int before = groups.empty() ? 0 : groups.back().halo;
    const bool joins = before == 0 || stages[i].halo == 0 || before + stages[i].halo <= kSmallHalo;
    if (groups.empty() || !joins) groups.push_back({i, i});
    groups.back().halo += stages[i].halo;
    groups.back().end = i + 1;
  }
  return groups;
}

}  // namespace

FilterWindow largestInput(const PartGroup& group, int width, int height) {
  return partInMidst(group, width, height).grown(group.halo);
}

std::vector<PartGroup> planParts(Stages stages, int width, int height, const PartLimits& limits) {
  PartGroup whole{0, stages.size(), 0, std::max(width, height)};
  for (const PlannedStage& stage : stages) whole.halo += stage.halo;
  if (whole.side <= std::min(limits.side, limits.textureSide) &&
      bytesHeld(stages, whole, width, height) <= limits.textureBytes)
    return {whole};
  std::vector<PartGroup> groups = groupsOf(stages);
  for (PartGroup& group : groups) setSide(group, stages, width, height, limits);
  return groups;
}

}  // namespace swaplight
