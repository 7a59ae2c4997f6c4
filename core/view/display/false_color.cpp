#include "core/view/display/false_color.h"

#include <array>
#include <cmath>
#include <limits>

namespace swaplight {
namespace {

constexpr float kMiddleGrey = 0.18F;

constexpr std::array<FalseColorBand, 13> kBands{{
    {-std::numeric_limits<float>::infinity(), {0.00F, 0.00F, 0.00F}, "below -6"},
    {-6.5F, {0.22F, 0.05F, 0.32F}, "-6"},
    {-5.5F, {0.36F, 0.13F, 0.60F}, "-5"},
    {-4.5F, {0.16F, 0.22F, 0.78F}, "-4"},
    {-3.5F, {0.10F, 0.45F, 0.85F}, "-3"},
    {-2.5F, {0.10F, 0.65F, 0.65F}, "-2"},
    {-1.5F, {0.15F, 0.55F, 0.25F}, "-1"},
    {-0.5F, {0.50F, 0.50F, 0.50F}, "middle grey"},
    {0.5F, {0.55F, 0.78F, 0.25F}, "+1"},
    {1.5F, {0.95F, 0.85F, 0.20F}, "+2"},
    {2.5F, {0.95F, 0.55F, 0.12F}, "+3"},
    {3.5F, {0.85F, 0.15F, 0.12F}, "+4"},
    {4.5F, {1.00F, 1.00F, 1.00F}, "above +4"},
}};

}  // namespace

std::span<const FalseColorBand> falseColorBands() {
  return kBands;
}

Rgb falseColor(float luminance) {
  const float stops =
      luminance > 0 ? std::log2(luminance / kMiddleGrey) : -std::numeric_limits<float>::infinity();
  Rgb color = kBands.front().color;
  for (const FalseColorBand& band : kBands)
    if (stops >= band.stops) color = band.color;
  return color;
}

}  // namespace swaplight
