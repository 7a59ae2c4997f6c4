#include "core/shadow/evidence/shadow_evidence.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/shadow/evidence/each_light.h"
#include "core/shadow/evidence/shared_reflectance.h"
#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

// Each pixel goes towards its neighbourhood's mean by how much of the variance there is noise.
cv::Mat denoised(cv::Mat x, cv::Mat variance, const ShadowEvidenceTuning& tuning) {
  const cv::Size window(2 * tuning.denoiseRadius + 1, 2 * tuning.denoiseRadius + 1);
  const auto box = [&](const cv::Mat& m) {
    cv::Mat out;
    cv::boxFilter(m, out, CV_32F, window, {-1, -1}, true, cv::BORDER_REFLECT);
    return out;
  };
  for (int round = 0; round < 2; ++round) {
    const cv::Mat mean = box(x);
    cv::Mat spread = box(x.mul(x)) - mean.mul(mean);
    cv::max(spread, 1e-14, spread);
    cv::Mat keep = (spread - variance) / spread;
    cv::max(keep, 0, keep);
    const cv::Mat base = (1 - keep).mul(mean);
    x = box(keep).mul(x) + box(base);
    variance = variance * tuning.denoisedVariance;
  }
  cv::max(x, 0, x);
  return x;
}

cv::Mat logarithm(const cv::Mat& x, float floor) {
  cv::Mat out = x + floor;
  cv::log(out, out);
  return out;
}

// A shadow's edge changes one light alone: the part of the light's slope that the others' slope does not
// have.
void findEdges(const cv::Mat& own, const cv::Mat& others, double blur, ShadowEvidence& evidence) {
  const auto slopes = [&](const cv::Mat& x, cv::Mat& sx, cv::Mat& sy) {
    cv::Mat soft;
    cv::GaussianBlur(x, soft, {}, blur, 0, cv::BORDER_REFLECT);
    cv::Sobel(soft, sx, CV_32F, 1, 0, 1, .5, 0, cv::BORDER_REFLECT);
    cv::Sobel(soft, sy, CV_32F, 0, 1, 1, .5, 0, cv::BORDER_REFLECT);
  };
  cv::Mat ax, ay, bx, by;
  slopes(own, ax, ay);
  slopes(others, bx, by);
  evidence.edge.create(own.size(), CV_32F);
  evidence.slope.create(own.size(), CV_32F);
  for (int y = 0; y < own.rows; ++y)
    for (int x = 0; x < own.cols; ++x) {
      const float gx = ax.at<float>(y, x);
      const float gy = ay.at<float>(y, x);
      const float size2 = gx * gx + gy * gy;
      const float common = gx * bx.at<float>(y, x) + gy * by.at<float>(y, x);
      const float unshared = std::clamp(1 - common / std::max(size2, 1e-9f), 0.f, 1.f);
      evidence.slope.at<float>(y, x) = std::sqrt(size2);
      evidence.edge.at<float>(y, x) = unshared * std::sqrt(size2);
    }
}

}  // namespace

SetEvidence gatherShadowEvidence(const SolvedSet& set, const Progress& progress,
                                 const ShadowEvidenceTuning& tuning) {
  constexpr const char* kWhat = "separating surfaces and shadows";
  SetEvidence all;
  const size_t count = set.contributions.size();
  const cv::Size size(set.width(), set.height());

  // Scale and noise.
  cv::Mat total(size, CV_32F, cv::Scalar(0));
  for (const Image& t : set.contributions)
    for (int c = 0; c < 3; ++c) total += planeOf(t, c) / 3;
  all.white = std::max(percentile(total, .99), 1e-12f);
  total /= all.white;
  cv::Mat sigma(size, CV_32F, cv::Scalar(0));
  if (!set.quality.empty()) sigma = planeOf(set.quality, kSigma).mul(total);
  cv::patchNaNs(sigma, 0);

  // Contributions without noise, their greys, and the logarithms of those.
  std::vector<cv::Mat> greys(count);
  all.contributions.resize(count);
  forEachLight(count, progress.part(0, .5f), kWhat, [&](size_t i) {
    const Image& t = set.contributions[i];
    cv::Mat channels[3];
    for (int c = 0; c < 3; ++c)
      channels[c] = denoised(planeOf(t, c) / all.white, sigma.mul(sigma) * 3, tuning);
    cv::merge(channels, 3, all.contributions[i]);
    const cv::Mat grey = (planeOf(t, 0) + planeOf(t, 1) + planeOf(t, 2)) / (3 * all.white);
    greys[i] = denoised(grey, sigma.mul(sigma), tuning);
  });
  cv::Mat sum(size, CV_32F, cv::Scalar(0));
  for (const cv::Mat& grey : greys) sum += grey;
  // More than a pixel's standard error: of which the filter leaves about a sixth.
  all.known = (sum > tuning.leastLight) & (sum > sigma);
  cv::medianBlur(all.known, all.known, 2 * tuning.knownRadius + 1);  // noise does not decide pixel by pixel
  const float floor = tuning.leastLight + tuning.noiseFloor * percentile(sigma, .5);
  std::vector<cv::Mat> logs;
  logs.reserve(greys.size());
  for (const cv::Mat& grey : greys) logs.push_back(logarithm(grey, floor));

  progress.update(.5f, kWhat);
  const cv::Mat reflectance = sharedReflectance(logs);

  all.lights.resize(count);
  forEachLight(count, progress.part(.7f, 1), kWhat, [&](size_t i) {
    ShadowEvidence& light = all.lights[i];
    light.level = logs[i] - tuning.surfaceShare * reflectance;
    light.shading = logs[i] - reflectance;
    const cv::Mat others = logarithm(sum - greys[i], floor);
    light.ratio = logs[i] - others;
    light.shines =
        cv::countNonZero(greys[i] > tuning.leastLight) > tuning.shining * static_cast<double>(size.area());
    findEdges(logs[i], others, tuning.edgeBlur, light);
  });
  return all;
}

}  // namespace swaplight
