#include "core/illumination/even_light.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core/hal/hal.hpp>
#include <opencv2/imgproc.hpp>

namespace swaplight {
namespace {

// Chosen on random_1, 3, 7, 8 and 10 of the rendered sets, against the light over an even dome's.
constexpr double kWindow = 0.12;  // widths of the picture
constexpr double kShareRidge = 1e-3;
constexpr double kColorRidge = 1e-2;

constexpr double kNoise = 1e-3;  // of the brightest light: below, shares and colours say nothing
constexpr double kFaint = 0.02;  // of the brightest light: counts half
constexpr double kDarkest = 1e-12;

// Half a stop, squared: log light that varies less around a pixel is relief, that varies more a shadow's
// edge.
constexpr double kEdge = 0.12;
constexpr double kReliefFloor = 0.01;  // of the bright part of the light

double brightOf(const cv::Mat& light) {
  return std::max(quantileOf(light, 0.99), kDarkest);
}

// The colour of what all lights together show: log R / G or B / G, 0 on the average.
cv::Mat logColor(const cv::Mat& channel, const cv::Mat& green, double floor, const cv::Mat& weight) {
  cv::Mat color;
  cv::log((channel + floor) / (green + floor), color);
  const double count = cv::sum(weight)[0];
  return count > 0 ? cv::Mat(color - color.dot(weight) / count) : color;
}

cv::Mat logOf(const cv::Mat& x) {
  cv::Mat logarithm;
  cv::log(x, logarithm);
  return logarithm;
}

}  // namespace

EvenLight::EvenLight(const SmallLights& small) : m_lights(small.light.size()) {
  const double bright = brightOf(small.sum);
  const double floor = kNoise * bright;
  m_floor = static_cast<float>(floor);
  const cv::Mat level = logOf(small.sum + floor);
  const cv::Mat weight = small.sum / (small.sum + kFaint * bright);
  std::vector<FitGuide> guides;
  for (const cv::Mat& light : small.light) {
    cv::Mat root;
    cv::sqrt(cv::max(light, 0) / (small.sum + floor), root);
    guides.push_back({root, kShareRidge});
  }
  for (const int c : {0, 2})
    guides.push_back({logColor(small.color[c], small.color[1], floor, weight), kColorRidge});
  m_level = fitLocally(level, guides, weight, std::max(kWindow * level.cols, 0.5));
  m_level.slopes.resize(m_lights);  // without what goes along with colour
  double least = 0;
  double most = 0;
  cv::minMaxLoc(level, &least, &most);
  m_least = static_cast<float>(least);
  m_most = static_cast<float>(most);
}

void EvenLight::row(const float* const* light, const SmallRow& at, int count, float* const* out) const {
  const auto size = static_cast<size_t>(count);
  std::vector<float> all(size, m_floor);
  for (size_t k = 0; k < m_lights; ++k)
    for (size_t i = 0; i < size; ++i) all[i] += std::max(light[k][i], 0.F);
  std::vector<float> level(size);
  std::vector<float> root(size);
  std::vector<float> slope(size);
  sampleRow(m_level.offset, at, count, level.data());
  for (size_t k = 0; k < m_lights; ++k) {
    for (size_t i = 0; i < size; ++i) out[k][i] = std::max(light[k][i], 0.F) / all[i];
    cv::hal::sqrt32f(out[k], root.data(), count);
    sampleRow(m_level.slopes[k], at, count, slope.data());
    for (size_t i = 0; i < size; ++i) level[i] += slope[i] * root[i];
  }
  for (float& value : level) value = std::clamp(value, m_least, m_most);
  cv::hal::exp32f(level.data(), level.data(), count);
  for (size_t k = 0; k < m_lights; ++k)
    for (size_t i = 0; i < size; ++i) out[k][i] *= level[i];
}

ReliefFilter::ReliefFilter(const cv::Mat& light, double sigma) {
  const double floor = std::max(kReliefFloor * quantileOf(light, 0.95), kDarkest);
  m_floor = static_cast<float>(floor);
  const cv::Mat level = logOf(light + floor);
  const auto mean = [&](const cv::Mat& x) {
    cv::Mat m;
    cv::GaussianBlur(x, m, {}, sigma, 0, cv::BORDER_REPLICATE);
    return m;
  };
  const cv::Mat middle = mean(level);
  const cv::Mat variance = cv::max(mean(level.mul(level)) - middle.mul(middle), 0);
  const cv::Mat slope = variance / (variance + kEdge);
  m_slope = mean(slope);
  m_offset = mean(middle.mul(1 - slope));
}

void ReliefFilter::row(const SmallRow& at, int count, float* light) const {
  const auto size = static_cast<size_t>(count);
  std::vector<float> slope(size);
  std::vector<float> offset(size);
  sampleRow(m_slope, at, count, slope.data());
  sampleRow(m_offset, at, count, offset.data());
  for (size_t i = 0; i < size; ++i) light[i] += m_floor;
  cv::hal::log32f(light, light, count);
  for (size_t i = 0; i < size; ++i) light[i] = slope[i] * light[i] + offset[i];
  cv::hal::exp32f(light, light, count);
  for (size_t i = 0; i < size; ++i) light[i] = std::max(light[i] - m_floor, 0.F);
}

}  // namespace swaplight
