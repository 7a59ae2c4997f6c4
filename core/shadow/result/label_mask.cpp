#include "core/shadow/result/label_mask.h"

#include <opencv2/imgproc.hpp>

namespace swaplight {
namespace {

cv::Mat unknownMask(const std::vector<ShadowLabel>& labels, int width) {
  cv::Mat mask(width > 0 ? static_cast<int>(labels.size()) / width : 0, width, CV_8U);
  for (size_t p = 0; p < labels.size(); ++p) mask.data[p] = labels[p] == ShadowLabel::Unknown ? 255 : 0;
  return mask;
}

}  // namespace

cv::Mat labelMask(const std::vector<ShadowLabel>& labels, int width, ShadowLabel lightest) {
  cv::Mat mask(width > 0 ? static_cast<int>(labels.size()) / width : 0, width, CV_8U);
  for (size_t p = 0; p < labels.size(); ++p)
    mask.data[p] = labels[p] != ShadowLabel::Unknown && labels[p] <= lightest ? 255 : 0;
  if (lightest == ShadowLabel::Penumbra) {
    const cv::Mat square = cv::Mat::ones(3, 3, CV_8U);
    const cv::Mat unknown = unknownMask(labels, width);
    cv::Mat beside, between;
    cv::dilate(labelMask(labels, width, ShadowLabel::Umbra), beside, square);
    cv::morphologyEx(mask, between, cv::MORPH_CLOSE, square);
    mask |= unknown & (between | (beside & ~untoldMask(labels, width)));
  }
  return mask;
}

cv::Mat untoldMask(const std::vector<ShadowLabel>& labels, int width) {
  cv::Mat mask = unknownMask(labels, width);
  if (mask.empty()) return mask;
  const cv::Mat square = cv::Mat::ones(2, 2, CV_8U);  // no middle: what one step moves the other moves back
  cv::erode(mask, mask, square, {0, 0});
  cv::dilate(mask, mask, square, {1, 1});
  return mask;
}

std::vector<Outline> outlinesOfMask(const cv::Mat& mask, float scale, float tolerance) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  std::vector<Outline> outlines;
  outlines.reserve(contours.size());
  std::vector<cv::Point> line;
  for (const std::vector<cv::Point>& contour : contours) {
    cv::approxPolyDP(contour, line, tolerance, true);
    Outline& outline = outlines.emplace_back();
    outline.reserve(line.size());
    for (const cv::Point& p : line)
      outline.push_back({(static_cast<float>(p.x) + .5f) * scale, (static_cast<float>(p.y) + .5f) * scale});
  }
  return outlines;
}

cv::Mat shadowRegions(const LightShadows& shadows) {
  cv::Mat regions;
  cv::connectedComponents(labelMask(shadows.labels, shadows.visibility.width(), ShadowLabel::Penumbra),
                          regions, 8, CV_32S);
  return regions;
}

}  // namespace swaplight
