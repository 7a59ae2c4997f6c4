#include <algorithm>
#include <cmath>

#include "core/ocio/color_config.h"
#include "core/relight/brightness.h"
#include "core/relight/live_level.h"
#include "core/relight/rig.h"

namespace swaplight {

std::vector<Rgb> rigFactors(const Rig& rig) {
  std::vector<Rgb> factors;
  for (size_t i = 0; i < rig.lights.size(); ++i)
    factors.push_back(
        liveLevel(rig, i).by != HeldBack::Nothing
            ? Rgb(0)
            : brightnessLimited(std::exp2(groupStops(rig, rig.lights[i])) * lightFactor(rig.lights[i])));
  return factors;
}

std::vector<Rgb> rigFactors(const ColorConfig& config, const Rig& rig, const std::string& colorSpace) {
  std::vector<Rgb> factors = rigFactors(rig);
  if (colorSpace == "lin_rec709" || factors.empty()) return factors;
  Image colors(ImageSpec::rgb(static_cast<int>(factors.size()), 1));
  for (size_t i = 0; i < factors.size(); ++i)
    for (int c = 0; c < 3; ++c) colors.plane(c)[i] = factors[i][c];
  config.convert(colors.span(), "lin_rec709", colorSpace);
  for (size_t i = 0; i < factors.size(); ++i)
    for (int c = 0; c < 3; ++c) factors[i][c] = std::max(0.0f, colors.plane(c)[i]);
  return factors;
}

}  // namespace swaplight
