#include "core/solve/registration/align_shots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "core/base/parallel.h"
#include "core/base/quantile.h"

namespace swaplight {
namespace {

constexpr int kSmallest = 48;            // pixels: the coarsest level's shorter side is no less
constexpr double kLeastAgreement = 0.3;  // correlation of the edges; unrelated pictures reach 0.1
constexpr float kWorthPixels = 0.1F;     // what registering lights of different colours is good to, at worst
constexpr int kParts = 4;                // across and down, that are registered by themselves
constexpr int kSmallestPart = 24;        // pixels of its sides
constexpr int kLargestPart = 256;
constexpr size_t kFewestParts = 4;  // that tell anything
constexpr float kBeyond = 2;        // spreads: of a camera that stands still up to 1.6 have been seen
constexpr int kTaps = 6;

/// Mean of the channels; broken values are black, light ends at the clip level.
cv::Mat luminance(const Image& shot, float clip) {
  cv::Mat grey(shot.height(), shot.width(), CV_32F);
  auto* out = grey.ptr<float>();
  for (size_t p = 0; p < shot.pixelCount(); ++p) {
    float sum = 0;
    for (int c = 0; c < 3; ++c)
      if (const float y = shot.plane(c)[p]; std::isfinite(y) && y > 0) sum += std::min(y, clip);
    out[p] = sum / 3;
  }
  return grey;
}

/// What survives a change of the light: edges of log luminance, over the mean edge around them.
cv::Mat edges(const cv::Mat& grey) {
  cv::Mat logarithm;
  cv::log(grey + (0.1 * cv::mean(grey)[0] + 1e-6), logarithm);
  cv::GaussianBlur(logarithm, logarithm, {}, 1.0);
  cv::Mat dx, dy, strength, around;
  cv::Scharr(logarithm, dx, CV_32F, 1, 0, 1.0 / 32);
  cv::Scharr(logarithm, dy, CV_32F, 0, 1, 1.0 / 32);
  cv::magnitude(dx, dy, strength);
  cv::blur(strength, around, {31, 31});
  return strength / (around + 0.5 * cv::mean(strength)[0] + 1e-9);
}

std::vector<cv::Mat> edgePyramid(const Image& shot, float clip) {
  std::vector<cv::Mat> levels;
  cv::Mat grey = luminance(shot, clip);
  levels.push_back(edges(grey));
  while (std::min(grey.cols, grey.rows) >= 2 * kSmallest) {
    cv::pyrDown(grey, grey);
    levels.push_back(edges(grey));
  }
  return levels;
}

/// Improves a translation; returns how well the edges agree then. Throws cv::Exception where they do not.
double improve(const cv::Mat& first, const cv::Mat& shot, cv::Mat& warp) {
  return cv::findTransformECC(first, shot, warp, cv::MOTION_TRANSLATION,
                              {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 60, 1e-5}, cv::noArray(), 5);
}

float spreadAround(float middle, std::vector<float> values) {
  for (float& value : values) value = std::abs(value - middle);
  return 1.4826F * median(std::span(values));
}

/// Registers parts of the picture by themselves, beginning with what the whole has found.
void measureSpread(const cv::Mat& first, const cv::Mat& shot, ShotShift& shift) {
  const cv::Size part(std::min(first.cols / kParts, kLargestPart),
                      std::min(first.rows / kParts, kLargestPart));
  if (std::min(part.width, part.height) < kSmallestPart) return;
  std::vector<float> x, y;
  for (int i = 0; i < kParts * kParts; ++i) {
    const cv::Point middle((2 * (i % kParts) + 1) * first.cols / (2 * kParts),
                           (2 * (i / kParts) + 1) * first.rows / (2 * kParts));
    const cv::Rect area(middle - cv::Point(part.width / 2, part.height / 2), part);
    cv::Mat warp = (cv::Mat_<float>(2, 3) << 1, 0, shift.x, 0, 1, shift.y);
    try {
      if (!(improve(first(area), shot(area), warp) > kLeastAgreement)) continue;
    } catch (const cv::Exception&) {
      continue;  // nothing to see there
    }
    x.push_back(warp.at<float>(0, 2));
    y.push_back(warp.at<float>(1, 2));
  }
  if (x.size() < kFewestParts) return;
  shift.spreadX = spreadAround(shift.x, std::move(x));
  shift.spreadY = spreadAround(shift.y, std::move(y));
}

ShotShift registered(const std::vector<cv::Mat>& first, const std::vector<cv::Mat>& shot) {
  const ShotShift none{0, 0, false};
  cv::Mat warp = cv::Mat::eye(2, 3, CV_32F);
  auto& x = warp.at<float>(0, 2);
  auto& y = warp.at<float>(1, 2);
  double agreement = 0;
  for (size_t level = first.size(); level-- > 0;) {
    x *= 2, y *= 2;
    try {
      agreement = improve(first[level], shot[level], warp);
    } catch (const cv::Exception&) {
      if (level == 0) return none;  // a coarse level may fail where a finer one does not
      x = y = 0;
    }
  }
  const float farthest = float(std::min(first[0].cols, first[0].rows)) / 12;
  if (!(agreement > kLeastAgreement) || !(std::hypot(x, y) < farthest)) return none;
  ShotShift shift{x, y, true};
  measureSpread(first[0], shot[0], shift);
  return shift;
}

/// Lanczos weights (three lobes) of the pixels -2 .. 3 around a position 0 <= fraction < 1.
std::array<float, kTaps> lanczos(float fraction) {
  const auto sinc = [](double t) { return std::abs(t) < 1e-7 ? 1.0 : std::sin(M_PI * t) / (M_PI * t); };
  std::array<float, kTaps> weight{};
  double sum = 0;
  std::array<double, kTaps> exact{};
  for (int j = 0; j < kTaps; ++j) {
    const double t = double(fraction) - (j - 2);
    sum += exact[size_t(j)] = std::abs(t) < 3 ? sinc(t) * sinc(t / 3) : 0;
  }
  for (size_t j = 0; j < kTaps; ++j) weight[j] = float(exact[j] / sum);
  return weight;
}

/// A plane moved by whole pixels and a fraction. A value that its two by two nearest pixels cannot give is
/// theirs: broken, or saturated.
void movePlane(const float* in, int width, int height, const ShotShift& shift, float clip, float* out) {
  const int left = int(std::floor(shift.x));
  const int up = int(std::floor(shift.y));
  const auto across = lanczos(shift.x - float(left));
  const auto down = lanczos(shift.y - float(up));
  const auto column = [&](int u) { return std::clamp(u, 0, width - 1); };
  const auto line = [&](int v) { return in + size_t(std::clamp(v, 0, height - 1)) * size_t(width); };
  parallelRows(height, 32, [&](int begin, int end) {
    std::vector<float> sum(static_cast<size_t>(width));
    for (int v = begin; v < end; ++v) {
      std::fill(sum.begin(), sum.end(), 0.0F);
      for (int j = 0; j < kTaps; ++j) {
        const float* row = line(v + up + j - 2);
        for (int u = 0; u < width; ++u)
          sum[size_t(u)] += down[size_t(j)] * (std::isfinite(row[u]) ? std::min(row[u], clip) : 0.0F);
      }
      float* to = out + size_t(v) * size_t(width);
      const float* above = line(v + up);
      const float* below = line(v + up + 1);
      for (int u = 0; u < width; ++u) {
        float value = 0;
        for (int j = 0; j < kTaps; ++j) value += across[size_t(j)] * sum[size_t(column(u + left + j - 2))];
        for (const float* row : {above, below})
          for (const int at : {column(u + left), column(u + left + 1)}) {
            if (!std::isfinite(row[at]))
              value = NAN;
            else if (row[at] >= clip)
              value = std::max(value, clip);  // NaN stays
          }
        to[u] = value;
      }
    }
  });
}

}  // namespace

std::vector<ShotShift> measureShifts(const CapturePixels& pixels) {
  std::vector<ShotShift> shifts(pixels.shots.size());
  if (pixels.shots.size() < 2) return shifts;
  const auto first = edgePyramid(pixels.shots[0], pixels.clipLevel[0]);
  for (size_t k = 1; k < pixels.shots.size(); ++k)
    shifts[k] = registered(first, edgePyramid(pixels.shots[k], pixels.clipLevel[k]));
  return shifts;
}

bool worthMoving(const ShotShift& shift) {
  const bool agreed =
      std::abs(shift.x) > kBeyond * shift.spreadX || std::abs(shift.y) > kBeyond * shift.spreadY;
  return shift.found && agreed && std::hypot(shift.x, shift.y) > kWorthPixels;
}

CapturePixels movedShots(const CapturePixels& pixels, const std::vector<ShotShift>& shifts) {
  CapturePixels moved = withoutShots(pixels);
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    const Image& shot = pixels.shots[k];
    if (!worthMoving(shifts[k])) {
      moved.shots.push_back(shot.clone());
      continue;
    }
    Image image(shot.spec());
    for (int c = 0; c < 3; ++c)
      movePlane(shot.plane(c), shot.width(), shot.height(), shifts[k], pixels.clipLevel[k], image.plane(c));
    moved.shots.push_back(std::move(image));
  }
  return moved;
}

bool outsideAny(const std::vector<ShotShift>& shifts, int x, int y, int width, int height) {
  return std::any_of(shifts.begin(), shifts.end(), [&](const ShotShift& shift) {
    if (!worthMoving(shift)) return false;
    const float u = float(x) + shift.x;
    const float v = float(y) + shift.y;
    return u < 0 || v < 0 || u > float(width - 1) || v > float(height - 1);
  });
}

std::vector<std::string> shiftWarnings(const std::vector<ShotShift>& shifts) {
  std::vector<std::string> warnings;
  for (size_t k = 0; k < shifts.size(); ++k)
    if (!shifts[k].found)
      warnings.push_back(fmt::format(
          "shot {} could not be aligned to the first: their edges do not match. It is used as it is; check "
          "that it shows the same picture",
          k + 1));
  return warnings;
}

}  // namespace swaplight
