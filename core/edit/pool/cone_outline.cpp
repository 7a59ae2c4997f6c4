#include "core/edit/pool/cone_outline.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace swaplight {
namespace {

constexpr double kLit = .5;
constexpr double kSpeck = .012;  // widths: what is narrower than twice this is a gleam or a gap
constexpr double kBite = .05;    // widths: shadows and things in front, so narrow, that are filled
constexpr double kMargin = .5;   // widths: how far the outline is followed beyond the picture

cv::Mat disk(double radius, int columns) {
  const int pixels = std::max(1, static_cast<int>(std::lround(radius * columns)));
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * pixels + 1, 2 * pixels + 1});
}

// The largest part that hangs together; 255 in it.
cv::Mat largestPart(const cv::Mat& lit) {
  cv::Mat labels, figures, middles;
  const int count = cv::connectedComponentsWithStats(lit, labels, figures, middles);
  int best = 0;
  for (int i = 1; i < count; ++i)
    if (best == 0 || figures.at<int>(i, cv::CC_STAT_AREA) > figures.at<int>(best, cv::CC_STAT_AREA)) best = i;
  return best == 0 ? cv::Mat::zeros(lit.size(), CV_8U) : cv::Mat(labels == best);
}

// Without its holes: what is dark and does not hang together with the surroundings.
cv::Mat filled(const cv::Mat& part) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(part, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat whole = cv::Mat::zeros(part.size(), CV_8U);
  cv::drawContours(whole, outlines, -1, cv::Scalar(255), cv::FILLED);
  return whole;
}

// Pixels from the edge, more than 0 inside.
cv::Mat insideOf(const cv::Mat& part) {
  cv::Mat inside, outside;
  cv::distanceTransform(part, inside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::distanceTransform(~part, outside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Mat distance = cv::max(inside - .5, 0) - cv::max(outside - .5, 0);
  cv::GaussianBlur(distance, distance, {}, 1, 0, cv::BORDER_REPLICATE);  // pixels' corners
  return distance;
}

}  // namespace

std::optional<ConeOutline> ConeOutline::in(const cv::Mat& seen) {
  ConeOutline outline;
  outline.m_columns = seen.cols;
  outline.m_rows = seen.rows;
  outline.m_margin = static_cast<int>(kMargin * seen.cols);
  const int margin = outline.m_margin;
  cv::Mat lit;
  cv::copyMakeBorder(seen > kLit, lit, margin, margin, margin, margin, cv::BORDER_REPLICATE);
  const cv::Rect picture(margin, margin, seen.cols, seen.rows);
  cv::morphologyEx(lit, lit, cv::MORPH_OPEN, disk(kSpeck, seen.cols), {-1, -1}, 1, cv::BORDER_REPLICATE);
  cv::Mat part;
  cv::copyMakeBorder(largestPart(lit(picture)), part, margin, margin, margin, margin, cv::BORDER_REPLICATE);
  cv::morphologyEx(part, part, cv::MORPH_CLOSE, disk(kBite, seen.cols), {-1, -1}, 1, cv::BORDER_REPLICATE);
  part = filled(part);

  const cv::Moments moments = cv::moments(part(picture), true);
  if (!(moments.m00 > 0) || moments.m00 >= static_cast<double>(seen.total())) return std::nullopt;
  outline.m_inside = insideOf(part) / seen.cols;
  outline.m_middle = {(moments.m10 / moments.m00 + .5) / seen.cols - .5,
                      (.5 * seen.rows - (moments.m01 / moments.m00 + .5)) / seen.cols};
  outline.m_spread = std::sqrt(moments.m00 / CV_PI) / seen.cols;
  for (const cv::Rect& border : {cv::Rect(0, 0, seen.cols, 1), cv::Rect(0, seen.rows - 1, seen.cols, 1),
                                 cv::Rect(0, 0, 1, seen.rows), cv::Rect(seen.cols - 1, 0, 1, seen.rows)})
    outline.m_cut |= cv::countNonZero(part(picture)(border)) > 0;
  double deepest = 0;
  cv::minMaxLoc(outline.m_inside(picture), nullptr, &deepest);
  if (!(deepest > 0)) return std::nullopt;
  outline.m_deepest = deepest;
  return outline;
}

double ConeOutline::radius(double px, double py) const {
  const auto clamped = [](double at, int count) { return std::clamp(at, 0., count - 1.001); };
  const double column = clamped((px + .5) * m_columns - .5 + m_margin, m_inside.cols);
  const double row = clamped(.5 * m_rows - py * m_columns - .5 + m_margin, m_inside.rows);
  const int x = static_cast<int>(column), y = static_cast<int>(row);
  const double u = column - x, v = row - y;
  const auto* above = m_inside.ptr<float>(y);
  const auto* below = m_inside.ptr<float>(y + 1);
  const double inside =
      (1 - v) * ((1 - u) * above[x] + u * above[x + 1]) + v * ((1 - u) * below[x] + u * below[x + 1]);
  return std::max(1 - (inside - m_shift) / m_deepest, 0.);
}

void ConeOutline::setEdge(double radius) {
  m_shift += (1 - radius) * m_deepest;
  m_deepest *= radius;
  m_spread *= radius;
}

}  // namespace swaplight
