#include "core/ocio/display_luminance.h"

#include <algorithm>

#include "core/ocio/color_config_impl.h"

namespace swaplight {
namespace {

constexpr size_t kSteps = 4096;
constexpr float kNitsOfOne = 100;

}  // namespace

DisplayLuminance::DisplayLuminance(const ColorConfig& config, const DisplayChoice& choice) {
  const OCIO::ConstCPUProcessorRcPtr light = config.impl().shownLight(namedDisplay(config, choice));
  if (!light) return;
  float brightest = 0;
  for (size_t i = 0; i <= kSteps; ++i) {
    const float code = static_cast<float>(i) / kSteps;
    float xyz[3] = {code, code, code};
    light->applyRGB(xyz);
    brightest = std::max(brightest, kNitsOfOne * xyz[1]);
    m_nits.push_back(brightest);
  }
}

float DisplayLuminance::nits(float code) const {
  const float place = std::clamp(code, 0.0F, 1.0F) * kSteps;
  const auto below = std::min(static_cast<size_t>(place), kSteps - 1);
  const float part = place - static_cast<float>(below);
  return m_nits[below] + part * (m_nits[below + 1] - m_nits[below]);
}

float DisplayLuminance::code(float nits) const {
  const auto above = std::lower_bound(m_nits.begin(), m_nits.end(), nits);
  if (above == m_nits.begin()) return 0;
  if (above == m_nits.end()) return 1;
  const float below = *(above - 1), part = (nits - below) / (*above - below);
  return (static_cast<float>(above - m_nits.begin() - 1) + part) / kSteps;
}

}  // namespace swaplight
