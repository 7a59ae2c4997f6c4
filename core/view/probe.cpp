#include "core/view/probe.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/relight/rig_edit.h"

namespace swaplight {
namespace {

constexpr float kMiddleGrey = 0.18F;

}  // namespace

PixelProbe probePixels(const ColorConfig& config, const SolvedSet& set, const Rig& rig, int x, int y,
                       int side, const DisplayTable& table, const Rgb& luminanceWeights) {
  const int low = (side - 1) / 2;
  const int x0 = std::max(0, x - low), x1 = std::min(set.width(), x - low + side);
  const int y0 = std::max(0, y - low), y1 = std::min(set.height(), y - low + side);

  PixelProbe probe;
  PixelShares mean{std::vector<Rgb>(set.contributions.size(), Rgb(0)), Rgb(0)};
  const ImageView quality = set.quality.view();
  for (int row = y0; row < y1; ++row)
    for (int column = x0; column < x1; ++column) {
      const PixelShares shares = pixelShares(set, column, row);
      for (size_t i = 0; i < mean.lights.size(); ++i) mean.lights[i] += shares.lights[i];
      mean.ambient += shares.ambient;
      if (quality.width == 0) continue;
      probe.residual = std::max(probe.residual, quality.at(kResidual, column, row));
      probe.sigma = std::max(probe.sigma, quality.at(kSigma, column, row));
      probe.flags |= static_cast<int>(quality.at(kFlags, column, row));
    }
  const float count = static_cast<float>((x1 - x0) * (y1 - y0));
  for (Rgb& light : mean.lights) light /= count;
  mean.ambient /= count;

  for (const Rgb& given : relitShares(config, rig, mean, set.colorSpace())) {
    probe.linear += given;
    probe.shares.push_back(std::max(0.0F, glm::dot(luminanceWeights, given)));
  }
  float sum = 0;
  for (const float share : probe.shares) sum += share;
  if (sum > 0)
    for (float& share : probe.shares) share /= sum;
  const float luminance = glm::dot(luminanceWeights, probe.linear);
  probe.stops = luminance > 0 ? std::log2(luminance / kMiddleGrey) : -std::numeric_limits<float>::infinity();
  std::array<uint8_t, 4> code{};
  table.apply(&probe.linear.r, &probe.linear.g, &probe.linear.b, 1, code.data());
  std::copy_n(code.begin(), 3, probe.code.begin());
  return probe;
}

}  // namespace swaplight
