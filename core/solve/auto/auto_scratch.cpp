#include "core/solve/auto/auto_scratch.h"

namespace swaplight {

AutoScratch::AutoScratch(SolvedSet& set) {
  const auto quality = [&](int plane) { return set.quality.span().channelRange(plane, 1); };
  const auto contribution = [&](size_t light, int channel) {
    return set.contributions[light].span().channelRange(channel, 1);
  };
  misfit = quality(kResidual);
  shareVariance = quality(kSigma);
  odds = quality(kModel);
  edgeFactor = contribution(0, 2);
  if (set.contributions.size() < 2) return;
  for (size_t light = 0; light < set.contributions.size(); ++light)
    nearShares.push_back(contribution(light, 0));
  nearVariance = contribution(0, 1);
  guide = contribution(1, 1);
}

}  // namespace swaplight
