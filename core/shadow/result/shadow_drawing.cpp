#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/color/srgb.h"
#include "core/measure/difference.h"
#include "core/plot/text_drawing.h"
#include "core/shadow/result/label_mask.h"
#include "core/shadow/result/shadow_file.h"
#include "core/shadow/result/shadow_outline.h"

namespace swaplight {
namespace {

constexpr float kDimming = .75f;
constexpr int kGrain = 64;       // rows at a time
constexpr int kTones = 1 << 14;  // of light, each of which has its code: less than a sixth of one apart
const std::array<cv::Scalar, 6> kColors = {cv::Scalar(255, 200, 40),  cv::Scalar(70, 200, 255),
                                           cv::Scalar(255, 90, 160),  cv::Scalar(120, 240, 120),
                                           cv::Scalar(190, 140, 255), cv::Scalar(255, 140, 60)};

cv::Mat displayed(const Image& linear) {
  const float scale = displayScale(linear.view()) * (kTones - 1);
  std::vector<uchar> codes(kTones);
  for (int tone = 0; tone < kTones; ++tone)
    codes[static_cast<size_t>(tone)] =
        cv::saturate_cast<uchar>(kDimming * srgbFromLinear(static_cast<float>(tone) / (kTones - 1)) * 255);
  cv::Mat picture(linear.height(), linear.width(), CV_8UC3);
  parallelRows(picture.rows, kGrain, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < picture.cols; ++x)
        for (int c = 0; c < 3; ++c) {
          const float tone = scale * linear.view().at(c, x, y) + .5f;
          const bool shown = tone > 0;  // and a number
          picture.at<cv::Vec3b>(y, x)[c] =
              codes[shown ? static_cast<size_t>(std::min(tone, kTones - 1.f)) : 0];
        }
  });
  return picture;
}

Image imageOf(const cv::Mat& picture) {
  Image image(ImageSpec{picture.cols, picture.rows, {"R", "G", "B"}, "srgb"});
  parallelRows(picture.rows, kGrain, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < picture.cols; ++x)
        for (int c = 0; c < 3; ++c)
          image.span().at(c, x, y) = static_cast<float>(picture.at<cv::Vec3b>(y, x)[c]) / 255.f;
  });
  return image;
}

void outline(cv::Mat& picture, const LightShadows& shadows, ShadowLabel lightest, const cv::Scalar& color,
             int thickness) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(labelMask(shadows.labels, picture.cols, lightest), contours, cv::RETR_LIST,
                   cv::CHAIN_APPROX_NONE);
  cv::drawContours(picture, contours, -1, color, thickness, cv::LINE_AA);
}

/// Ticks on the shadow's side, where a line alone does not say which side that is.
void tickShadows(cv::Mat& picture, const LightShadows& shadows, const cv::Scalar& color) {
  const float length = std::max(2.f, static_cast<float>(picture.rows) / 180);
  for (const Outline& line : shadowOutlines(shadows.labels, picture.cols).penumbra)
    for (const auto& [from, to] : shadowTicks(line, 2 * length, length))
      cv::line(picture, cv::Point2f(from[0] - .5f, from[1] - .5f), cv::Point2f(to[0] - .5f, to[1] - .5f),
               color, 1, cv::LINE_AA);
}

/// Rising lines, of each light between those of the others.
void hatchUntold(cv::Mat& picture, const LightShadows& shadows, const cv::Scalar& color, size_t light,
                 size_t count) {
  const int thick = std::max(1, picture.rows / 400);
  const int apart = std::max(8, picture.rows / 45) * static_cast<int>(count);
  const int shift = apart * static_cast<int>(light) / static_cast<int>(count);
  const cv::Vec3f ink(static_cast<float>(color[0]), static_cast<float>(color[1]),
                      static_cast<float>(color[2]));
  const cv::Mat untold = untoldMask(shadows.labels, picture.cols);
  parallelRows(picture.rows, kGrain, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto* untoldHere = untold.ptr<uchar>(y);
      for (int x = 0; x < picture.cols; ++x) {
        if (!untoldHere[x] || (x + y + shift) % apart >= thick) continue;
        auto& here = picture.at<cv::Vec3b>(y, x);
        here = cv::Vec3f(here) * .4F + ink * .6F;
      }
    }
  });
}

}  // namespace

Image drawShadowOutlines(const SolvedSet& set, const std::vector<NamedShadows>& lights) {
  cv::Mat picture = displayed(sumAtUnitWhite(set));
  const int height = std::clamp(picture.rows / 26, 10, 60);
  for (size_t i = 0; i < lights.size(); ++i) {
    const cv::Scalar& color = kColors[i % kColors.size()];
    hatchUntold(picture, *lights[i].shadows, color, i, lights.size());
    tickShadows(picture, *lights[i].shadows, color * .55);
    outline(picture, *lights[i].shadows, ShadowLabel::Penumbra, color * .55, 1);
    outline(picture, *lights[i].shadows, ShadowLabel::Umbra, color, std::max(1, picture.rows / 400));
    drawText(picture, lights[i].light,
             {height / 2, static_cast<int>(static_cast<double>(height) * 1.4 * static_cast<double>(i + 1))},
             height, color);
  }
  return imageOf(picture);
}

}  // namespace swaplight
