#include "core/balance/illuminant.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <opencv2/imgproc.hpp>
#include <opencv2/xphoto/white_balance.hpp>
#include <vector>

#include "core/base/error.h"

namespace swaplight {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEbnerWindow = 0.093;  // of the larger side: his 2004 experiments
constexpr float kDarkest = 0.02F;       // of the brightest channel of a light: below, a quotient is noise

constexpr std::array<BalanceMethod, 9> kMethods = {{
    {"grey-world", "the picture's mean is grey (Buchsbaum 1980)"},
    {"max-rgb", "the brightest of each channel is white (Land 1977)"},
    {"shades-of-grey", "the mean of 6th powers is grey (Finlayson and Trezzi 2004)"},
    {"grey-edge", "the mean of edges is grey (van de Weijer et al. 2007)"},
    {"grey-edge-2", "the mean of second derivatives is grey (the same)"},
    {"ebner", "the surroundings of a pixel are grey (Ebner 2007)"},
    {"xphoto-simple", "stretched channels (OpenCV)"},
    {"xphoto-grey-world", "grey world without saturated pixels (OpenCV)"},
    {"xphoto-learning", "a learned estimate (OpenCV, after Cheng et al. 2015)"},
}};

const std::map<std::string, IlluminantStatistic>& statistics() {
  static const std::map<std::string, IlluminantStatistic> all = {{"grey-world", {0, 1, 0}},
                                                                 {"max-rgb", {0, kInfinity, 0}},
                                                                 {"shades-of-grey", {0, 6, 0}},
                                                                 {"grey-edge", {1, 1, 2}},
                                                                 {"grey-edge-2", {2, 1, 2}}};
  return all;
}

/// Pixels that tell something: 255, else 0.
cv::Mat usable(const Image& picture, float clip) {
  cv::Mat mask(picture.height(), picture.width(), CV_8U);
  for (size_t p = 0; p < picture.pixelCount(); ++p) {
    bool good = true;
    for (int c = 0; c < 3; ++c) good &= std::isfinite(picture.plane(c)[p]) && picture.plane(c)[p] < clip;
    mask.ptr<uint8_t>()[p] = good ? 255 : 0;
  }
  return mask;
}

/// A channel without what is not finite or negative.
cv::Mat plane(const Image& picture, int channel) {
  cv::Mat copy(picture.height(), picture.width(), CV_32F);
  const float* from = picture.plane(channel);
  for (size_t p = 0; p < picture.pixelCount(); ++p)
    copy.ptr<float>()[p] = std::isfinite(from[p]) ? std::max(0.F, from[p]) : 0;
  return copy;
}

cv::Mat derived(cv::Mat y, const IlluminantStatistic& statistic) {
  if (statistic.sigma > 0) cv::GaussianBlur(y, y, {}, statistic.sigma);
  if (statistic.derivative == 0) return y;
  const auto derivative = [&](int dx, int dy) {
    cv::Mat out;
    cv::Sobel(y, out, CV_32F, dx, dy);
    return out;
  };
  cv::Mat magnitude;
  if (statistic.derivative == 1) {
    cv::magnitude(derivative(1, 0), derivative(0, 1), magnitude);
    return magnitude;
  }
  const cv::Mat xx = derivative(2, 0), xy = derivative(1, 1), yy = derivative(0, 2);
  cv::sqrt(xx.mul(xx) + 4 * xy.mul(xy) + yy.mul(yy), magnitude);
  return magnitude;
}

/// (mean of |value|^p)^(1/p) over the mask.
double minkowski(const cv::Mat& values, const cv::Mat& mask, double norm) {
  double largest = 0;
  cv::minMaxLoc(values, nullptr, &largest, nullptr, nullptr, mask);
  if (norm == kInfinity || !(largest > 0)) return largest;
  double sum = 0;
  size_t count = 0;
  for (size_t p = 0; p < values.total(); ++p)
    if (mask.ptr<uint8_t>()[p]) sum += std::pow(double(values.ptr<float>()[p]) / largest, norm), ++count;
  return largest * std::pow(sum / double(count), 1 / norm);
}

/// Balances every pixel by a light of its own, whose luminance is 1.
template <typename Light>
Image balanced(const Image& picture, const Rgb& white, const Light& light) {
  Image out = picture.clone();
  for (size_t p = 0; p < picture.pixelCount(); ++p) {
    const Rgb l = light(p);
    const Rgb floored = glm::max(l, Rgb(kDarkest * std::max({l.r, l.g, l.b})));
    for (int c = 0; c < 3; ++c) {
      const float y = picture.plane(c)[p];
      out.plane(c)[p] = std::isfinite(y) ? y * white[c] / floored[c] : 0;
    }
  }
  return out;
}

Image balanceByEbner(const Image& picture, const Rgb& white, const Rgb& weights) {
  std::array<cv::Mat, 3> average;
  for (int c = 0; c < 3; ++c) {
    average[size_t(c)] = plane(picture, c);
    const double sigma = kEbnerWindow * std::max(picture.width(), picture.height());
    cv::GaussianBlur(average[size_t(c)], average[size_t(c)], {}, sigma);
  }
  return balanced(picture, white, [&](size_t p) {
    const Rgb a(average[0].ptr<float>()[p], average[1].ptr<float>()[p], average[2].ptr<float>()[p]);
    const float y = glm::dot(a, weights);
    return y > 0 ? a / y : Rgb(1);
  });
}

/// xphoto works on 16-bit BGR; the picture's largest value becomes full scale.
Image balanceByXphoto(const Image& picture, const std::string& method, const Rgb& white, const Rgb& weights) {
  std::vector<cv::Mat> planes{plane(picture, 2), plane(picture, 1), plane(picture, 0)};
  double largest = 0;
  for (const cv::Mat& one : planes) {
    double most = 0;
    cv::minMaxLoc(one, nullptr, &most);
    largest = std::max(largest, most);
  }
  cv::Mat codes, result;
  cv::merge(planes, codes);
  codes.convertTo(codes, CV_16UC3, largest > 0 ? 65535 / largest : 1);
  if (method == "xphoto-simple") {  // takes floats, not 16 bits
    const auto simple = cv::xphoto::createSimpleWB();
    simple->setInputMax(65535);
    simple->setOutputMax(65535);
    codes.convertTo(codes, CV_32FC3);
    simple->balanceWhite(codes, result);
  } else if (method == "xphoto-grey-world")
    cv::xphoto::createGrayworldWB()->balanceWhite(codes, result);
  else {
    const auto learning = cv::xphoto::createLearningBasedWB();
    learning->setRangeMaxVal(65535);
    learning->balanceWhite(codes, result);
  }
  result.convertTo(result, CV_32FC3, largest / 65535);
  cv::split(result, planes);
  Image out(picture.spec());
  const auto luminanceOf = [&](const auto& value) {
    double sum = 0;
    for (size_t p = 0; p < picture.pixelCount(); ++p)
      for (int c = 0; c < 3; ++c) sum += double(weights[c]) * double(value(c, p));
    return sum;
  };
  const auto after = [&](int c, size_t p) { return planes[size_t(2 - c)].ptr<float>()[p]; };
  const auto before = [&](int c, size_t p) {
    const float y = picture.plane(c)[p];
    return std::isfinite(y) ? y : 0;
  };
  const double brighter = luminanceOf(after);
  const float scale = brighter > 0 ? float(luminanceOf(before) / brighter) : 1;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < picture.pixelCount(); ++p) out.plane(c)[p] = scale * white[c] * after(c, p);
  return out;
}

}  // namespace

Rgb estimateIlluminant(const Image& picture, float clip, const IlluminantStatistic& statistic) {
  const cv::Mat mask = usable(picture, clip);
  Rgb light(1);
  if (cv::countNonZero(mask) == 0) return light;
  for (int c = 0; c < 3; ++c)
    light[c] = float(minkowski(derived(plane(picture, c), statistic), mask, statistic.norm));
  return std::max({light.r, light.g, light.b}) > 0 ? light : Rgb(1);
}

std::span<const BalanceMethod> balanceMethods() {
  return kMethods;
}

Image balanceByColor(const Image& picture, const Rgb& light, const Rgb& white, const Rgb& luminanceWeights) {
  const Rgb one = light / glm::dot(light, luminanceWeights);
  return balanced(picture, white, [&](size_t /*p*/) { return one; });
}

Image balanceByMethod(const Image& picture, float clip, const std::string& method, const Rgb& white,
                      const Rgb& luminanceWeights) {
  if (const auto found = statistics().find(method); found != statistics().end())
    return balanceByColor(picture, estimateIlluminant(picture, clip, found->second), white, luminanceWeights);
  if (method == "ebner") return balanceByEbner(picture, white, luminanceWeights);
  for (const BalanceMethod& known : kMethods)
    if (method == known.name) return balanceByXphoto(picture, method, white, luminanceWeights);
  std::vector<std::string_view> names;
  for (const BalanceMethod& known : kMethods) names.emplace_back(known.name);
  throw InputError("'{}' is no method of white balance; known are {}", method, fmt::join(names, ", "));
}

}  // namespace swaplight
