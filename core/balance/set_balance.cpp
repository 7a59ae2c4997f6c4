#include "core/balance/set_balance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/check.h"
#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr int kWindow = 9;  // pixels: residuals that tell noise from something else
constexpr float kFaintestChannel =
    0.02F;  // of the brightest channel: a lamp's channel below is noise (BALANCE: the guard)
constexpr float kUniform = 1e-5F;  // of the mean contribution, added: what a pixel without light is taken for

cv::Mat planeOf(Image& image, int channel) {
  return {image.height(), image.width(), CV_32F, image.plane(channel)};
}

float meanOf(const SolvedSet& set) {
  double sum = 0;
  const Image& first = set.contributions.front();
  for (const Image& contribution : set.contributions)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < contribution.pixelCount(); ++p) sum += contribution.plane(c)[p];
  return float(sum / double(3 * first.pixelCount() * set.contributions.size()));
}

/// What the set says of the photograph (P), and what is wanted (Q).
struct Prediction {
  Image lit, wanted;
};

Prediction predict(const SolvedSet& set, const LampBalance& balance) {
  const float uniform = kUniform * meanOf(set);
  Prediction prediction{Image(set.contributions.front().spec()), Image(set.contributions.front().spec())};
  parallelRows(set.height(), 32, [&](int begin, int end) {
    const auto width = size_t(set.width());
    for (int c = 0; c < 3; ++c)
      for (size_t p = size_t(begin) * width; p < size_t(end) * width; ++p) {
        float lit = set.ambient ? balance.ambient * set.ambient->plane(c)[p] : 0;
        float wanted = lit;
        for (size_t i = 0; i < balance.lamps.size(); ++i) {
          const float contribution = set.contributions[i].plane(c)[p] + uniform;
          lit += balance.lamps[i][c] * contribution;
          wanted += balance.targets[i][c] * contribution;
        }
        prediction.lit.plane(c)[p] = lit;
        prediction.wanted.plane(c)[p] = wanted;
      }
  });
  return prediction;
}

/// What the photograph shows beyond the set; where it is clipped or broken, no less than nothing.
void residual(const Image& photograph, const Image& lit, float clip, int c, Image& out) {
  for (size_t p = 0; p < lit.pixelCount(); ++p) {
    const float y = photograph.plane(c)[p];
    const float r = y - lit.plane(c)[p];
    out.plane(c)[p] = !std::isfinite(y) ? 0 : y >= clip ? std::max(0.F, r) : r;
  }
}

/// k: the part of the residuals' variance that is no noise.
cv::Mat keptPart(Image& residuals, const Image& lit, const NoiseModel& noise, int c) {
  cv::Mat squares, variances(lit.height(), lit.width(), CV_32F);
  const cv::Mat r = planeOf(residuals, c);
  cv::multiply(r, r, squares);
  auto* variance = variances.ptr<float>();
  for (size_t p = 0; p < lit.pixelCount(); ++p) variance[p] = noise.variance(lit.plane(c)[p]);
  const cv::Size window(kWindow, kWindow);
  cv::blur(squares, squares, window, {-1, -1}, cv::BORDER_REFLECT);
  cv::blur(variances, variances, window, {-1, -1}, cv::BORDER_REFLECT);
  auto* kept = squares.ptr<float>();
  for (size_t p = 0; p < lit.pixelCount(); ++p)
    kept[p] = kept[p] > variance[p] ? 1 - variance[p] / kept[p] : 0;
  return squares;
}

}  // namespace

Image balanceBySet(const SolvedSet& set, const Image& photograph, float clip, const LampBalance& balance,
                   const NoiseModel& noise) {
  SWAPLIGHT_CHECK_EQ(balance.lamps.size(), set.contributions.size());
  SWAPLIGHT_CHECK_EQ(balance.targets.size(), set.contributions.size());
  const Prediction prediction = predict(set, balance);
  Image residuals(prediction.lit.spec());
  Image out = prediction.wanted.clone();
  parallelEach(3, [&](int c) {
    residual(photograph, prediction.lit, clip, c, residuals);
    const cv::Mat kept = keptPart(residuals, prediction.lit, noise, c);
    for (size_t p = 0; p < out.pixelCount(); ++p) {
      const float brightest =
          std::max({prediction.lit.plane(0)[p], prediction.lit.plane(1)[p], prediction.lit.plane(2)[p]});
      const float lit = std::max(prediction.lit.plane(c)[p], kFaintestChannel * brightest);
      const float gain = lit > 0 ? prediction.wanted.plane(c)[p] / lit : 1;
      out.plane(c)[p] = std::max(0.F, out.plane(c)[p] + kept.ptr<float>()[p] * gain * residuals.plane(c)[p]);
    }
  });
  return out;
}

std::vector<Rgb> whiteTargets(const std::vector<Rgb>& lamps, std::span<const size_t> chosen, const Rgb& white,
                              const Rgb& luminanceWeights) {
  std::vector<Rgb> targets = lamps;
  for (const size_t i : chosen)
    targets.at(i) = white * (glm::dot(lamps[i], luminanceWeights) / glm::dot(white, luminanceWeights));
  return targets;
}

}  // namespace swaplight
