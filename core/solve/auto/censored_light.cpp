#include "core/solve/auto/censored_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace swaplight {
namespace {

constexpr int kSweeps = 60;

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

CensoredLight::CensoredLight(const EstimatorContext& context, int channel,
                             std::span<const ShotSignal::Reading> readings, double modelError)
    : m_lighting(context.lighting), m_channel(channel), m_readings(readings) {
  for (const ShotSignal::Reading& reading : readings) {
    const double part = modelError * double(reading.light);
    m_weights.push_back(1 / (double(context.noise.variance(reading.light)) + part * part + 1e-12));
  }
}

double CensoredLight::predicted(size_t shot, std::span<const double> light) const {
  double sum = 0;
  for (int i = 0; i < m_lighting.lights; ++i) sum += color(shot, i) * light[size_t(i)];
  return sum;
}

double CensoredLight::scale(std::span<const double> proportions) const {
  double above = 0, below = 0, least = 0;
  for (size_t k = 0; k < m_readings.size(); ++k) {
    const double unit = predicted(k, proportions);
    if (!(unit > 0)) continue;
    if (m_readings[k].clipped) {
      least = std::max(least, double(m_readings[k].light) / unit);
    } else {
      above += m_weights[k] * unit * double(m_readings[k].light);
      below += m_weights[k] * unit * unit;
    }
  }
  return std::max(least, below > 0 ? above / below : 0);
}

void CensoredLight::descend(std::vector<double>& light, const Prior& prior, double settled) const {
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    if (this->sweep(light, prior) < settled) break;
}

double CensoredLight::sweep(std::vector<double>& light, const Prior& prior) const {
  const double squared = prior.weight > 0 ? product(prior.proportions, prior.proportions) : 1;
  double changed = 0;
  for (int i = 0; i < m_lighting.lights; ++i) {
    double curve = 0, wanted = 0;
    if (prior.weight > 0) {  // |T - b (b T) / bb|^2 = |T|^2 - (b T)^2 / bb
      const double share = prior.proportions[size_t(i)];
      const double along = product(prior.proportions, light) - share * light[size_t(i)];
      curve = prior.weight * (1 - share * share / squared);
      wanted = prior.weight * share * along / squared;
    }
    for (size_t k = 0; k < m_readings.size(); ++k) {
      const double own = color(k, i), all = predicted(k, light);
      if (m_readings[k].clipped && all >= double(m_readings[k].light)) continue;
      curve += m_weights[k] * own * own;
      wanted += m_weights[k] * own * (double(m_readings[k].light) - all + own * light[size_t(i)]);
    }
    if (!(curve > 0)) continue;
    const double now = std::max(wanted / curve, 0.0);
    changed = std::max(changed, std::abs(now - light[size_t(i)]));
    light[size_t(i)] = now;
  }
  return changed;
}

}  // namespace swaplight
