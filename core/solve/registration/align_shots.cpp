#include "core/solve/registration/align_shots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/solve/registration/part_shifts.h"
#include "core/solve/registration/shot_place.h"

namespace swaplight {
namespace {

constexpr int kSmallest = 48;  // pixels: the coarsest level's shorter side is no less

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

/// What moves a whole level of the picture onto the first's, from coarse to fine; [0] is the finest.
std::vector<ShotShift> shiftsOfLevels(const std::vector<cv::Mat>& first, const std::vector<cv::Mat>& shot) {
  std::vector<ShotShift> shifts(first.size());
  cv::Mat warp = cv::Mat::eye(2, 3, CV_32F);
  auto& x = warp.at<float>(0, 2);
  auto& y = warp.at<float>(1, 2);
  for (size_t level = first.size(); level-- > 0;) {
    x *= 2, y *= 2;
    try {
      const double agreement = improveTranslation(first[level], shot[level], warp);
      shifts[level] = {x, y, agreement > kLeastAgreement};
    } catch (const cv::Exception&) {
      shifts[level].found = false;  // a coarse level may fail where a finer one does not
      x = y = 0;
    }
  }
  return shifts;
}

/// What moves, turns and zooms the parts of the picture onto the first's; nothing where that is not sure.
std::optional<ShotShift> turnOf(const std::vector<cv::Mat>& first, const std::vector<cv::Mat>& shot,
                                const std::vector<ShotShift>& whole) {
  ShotShift at;
  bool begun = false;
  for (size_t level = first.size(); level-- > 0;) {
    at.x *= 2, at.y *= 2;
    if (!begun && whole[level].found) at = whole[level];
    const std::vector<PartShift> parts = partShifts(first[level], shot[level], at);
    const ShotShift fitted = fittedShift(parts);
    if (!fitted.found) continue;
    at = fitted, begun = true;
    if (level == 0 && surelyTurned(fitted, parts)) return fitted;
  }
  return std::nullopt;
}

ShotShift registered(const std::vector<cv::Mat>& first, const std::vector<cv::Mat>& shot) {
  const float farthest = float(std::min(first[0].cols, first[0].rows)) / 12;
  const auto isNear = [&](const ShotShift& shift) { return std::hypot(shift.x, shift.y) < farthest; };
  const std::vector<ShotShift> whole = shiftsOfLevels(first, shot);
  if (const auto turned = turnOf(first, shot, whole); turned && isNear(*turned)) return *turned;
  ShotShift shift = whole.front();
  if (!shift.found || !isNear(shift)) return {0, 0, false};
  measureSpread(partShifts(first[0], shot[0], shift), shift);
  return shift;
}

}  // namespace

std::vector<ShotShift> measureShifts(const CapturePixels& pixels, const Progress& progress) {
  std::vector<ShotShift> shifts(pixels.shots.size());
  if (pixels.shots.size() < 2) return shifts;
  const auto first = edgePyramid(pixels.shots[0], pixels.clipLevel[0]);
  for (size_t k = 1; k < pixels.shots.size(); ++k) {
    progress.stopIfAsked();
    shifts[k] = registered(first, edgePyramid(pixels.shots[k], pixels.clipLevel[k]));
  }
  return shifts;
}

bool worthMoving(const ShotShift& shift) {
  if (shift.isTurned()) return shift.found;
  const bool agreed =
      std::abs(shift.x) > kBeyondSpread * shift.spreadX || std::abs(shift.y) > kBeyondSpread * shift.spreadY;
  return shift.found && agreed && std::hypot(shift.x, shift.y) > kWorthPixels;
}

bool outsideAny(const std::vector<ShotShift>& shifts, int x, int y, int width, int height) {
  return std::any_of(shifts.begin(), shifts.end(), [&](const ShotShift& shift) {
    if (!worthMoving(shift)) return false;
    const auto [u, v] = ShotPlaces(shift, width, height)(float(x), float(y));
    return u < 0 || v < 0 || u > float(width - 1) || v > float(height - 1);
  });
}

float farthestMove(const std::vector<ShotShift>& shifts, int width, int height) {
  float farthest = 0;
  for (const ShotShift& shift : shifts)
    if (worthMoving(shift)) farthest = std::max(farthest, ShotPlaces(shift, width, height).farthestMove());
  return farthest;
}

std::vector<std::string> shiftWarnings(const std::vector<ShotShift>& shifts,
                                       const std::vector<std::string>& files) {
  std::vector<std::string> warnings;
  for (size_t k = 0; k < shifts.size(); ++k)
    if (!shifts[k].found)
      warnings.push_back(fmt::format(
          "shot {}{} could not be aligned to the first: their edges do not match. It is used as it is; check "
          "that it shows the same picture",
          k + 1, k < files.size() && !files[k].empty() ? fmt::format(" ({})", files[k]) : ""));
  return warnings;
}

std::vector<std::string> shiftWarnings(const std::vector<ShotShift>& shifts, const Capture& capture) {
  std::vector<std::string> files;
  for (const Shot& shot : capture.shots) files.push_back(shot.image);
  return shiftWarnings(shifts, files);
}

}  // namespace swaplight
