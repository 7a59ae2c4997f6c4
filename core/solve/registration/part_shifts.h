#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/set/shot_shift.h"

namespace swaplight {

/// How far a part of the picture lies from its place in the first shot, registered by itself.
struct PartShift {
  float u, v;  ///< the middle of the part, from that of the picture
  float x, y;  ///< pixels
};

/// Improves where a shot lies against the first: `warp` (2 x 3, CV_32F) takes places of the first to places
/// of the shot, and its translation is changed by the enhanced correlation coefficient (Evangelidis and
/// Psarakis 2008). Returns how well both agree then. Throws cv::Exception where they do not.
double improveTranslation(const cv::Mat& first, const cv::Mat& shot, cv::Mat& warp);

/// Sixteen parts of two pictures of edges, each registered by itself, beginning with `start`. Parts in which
/// nothing agrees are left out; none where the pictures are too small.
[[nodiscard]] std::vector<PartShift> partShifts(const cv::Mat& first, const cv::Mat& shot,
                                                const ShotShift& start);

/// Of parts that tell anything: the spread of what they are from `shift`. Zero where there are too few.
void measureSpread(const std::vector<PartShift>& parts, ShotShift& shift);

/// The shift, turn and zoom that fit the parts best, with its spread: least squares, robust (Tukey 1977). Not
/// found where there are too few.
[[nodiscard]] ShotShift fittedShift(const std::vector<PartShift>& parts);

/// Whether the camera has turned or zoomed: parts are displaced by that beyond what registering is good to,
/// and twice as far as they disagree about it.
[[nodiscard]] bool surelyTurned(const ShotShift& fitted, const std::vector<PartShift>& parts);

/// Correlation of edges below which nothing agrees; unrelated pictures reach 0.1.
constexpr double kLeastAgreement = 0.3;
/// What registering lights of different colours is good to, in pixels, at worst.
constexpr float kWorthPixels = 0.1F;
/// Spreads that a displacement has to be beyond: of a camera that stands still up to 1.6 have been seen.
constexpr float kBeyondSpread = 2;

}  // namespace swaplight
