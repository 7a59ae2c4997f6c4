#include "core/edit/mask/selection_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/edit/mask/mask_drawing.h"
#include "core/edit/mask/prepared_mask.h"

namespace swaplight {
namespace {

constexpr int kBand = 32;
constexpr int kSpeck = 5;         // pixels: the side of the median that takes specks away
constexpr double kSoftEdge = .8;  // sigma, so that the edge is no staircase
constexpr double kMostSigma = 6;  // a wider blur is made of a smaller picture

// What is compared: planes of the picture's size.
std::vector<cv::Mat> comparedPlanes(const SimilarShape& shape, const SolvedSet& set) {
  const bool byColor = shape.by == SimilarShape::By::Color;
  std::vector<cv::Mat> planes;
  for (int p = 0; p < (byColor ? 3 : set.lightCount()); ++p) {
    cv::Mat plane(set.height(), set.width(), CV_32F);
    parallelRows(plane.rows, kBand, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        float* out = plane.ptr<float>(y);
        if (!byColor) {
          std::copy_n(set.beta.view().row(p, y), plane.cols, out);
          continue;
        }
        std::fill_n(out, plane.cols, 0.F);
        for (const Image& light : set.contributions) {
          const float* in = light.view().row(p, y);
          for (int x = 0; x < plane.cols; ++x) out[x] += in[x];
        }
        for (int x = 0; x < plane.cols; ++x) out[x] = std::cbrt(std::max(out[x], 0.F));
      }
    });
    cv::blur(plane, plane, {3, 3});
    planes.push_back(std::move(plane));
  }
  return planes;
}

void blur(cv::Mat& pixels, double sigma) {
  int shrink = 1;
  while (sigma / shrink > kMostSigma) shrink *= 2;
  if (shrink == 1) {
    cv::GaussianBlur(pixels, pixels, {}, sigma, 0, cv::BORDER_CONSTANT);
    return;
  }
  const cv::Size size = pixels.size();
  cv::Mat small;
  cv::resize(pixels, small, {(size.width + shrink - 1) / shrink, (size.height + shrink - 1) / shrink}, 0, 0,
             cv::INTER_AREA);
  cv::GaussianBlur(small, small, {}, sigma / shrink, 0, cv::BORDER_CONSTANT);
  cv::resize(small, pixels, size, 0, 0, cv::INTER_LINEAR);
}

void combine(SelectionPart::Combine how, const float* part, int count, float* sum) {
  switch (how) {
    case SelectionPart::Combine::Add:
      for (int x = 0; x < count; ++x) sum[x] = std::max(sum[x], part[x]);
      return;
    case SelectionPart::Combine::Subtract:
      for (int x = 0; x < count; ++x) sum[x] = std::min(sum[x], 1 - part[x]);
      return;
    case SelectionPart::Combine::Intersect:
      for (int x = 0; x < count; ++x) sum[x] = std::min(sum[x], part[x]);
      return;
  }
}

}  // namespace

MaskRaster drawSimilar(const SimilarShape& shape, const SolvedSet& set) {
  const int width = set.width(), height = set.height();
  if (shape.x < 0 || shape.y < 0 || shape.x >= width || shape.y >= height)
    throw InputError("\"similar\": the place {}, {} is outside the picture of {} x {}.", shape.x, shape.y,
                     width, height);
  const cv::Rect around = cv::Rect(shape.x - 2, shape.y - 2, 5, 5) & cv::Rect(0, 0, width, height);
  cv::Mat like(height, width, CV_8U, cv::Scalar(255));
  for (const cv::Mat& plane : comparedPlanes(shape, set)) {
    const auto wanted = static_cast<float>(cv::mean(plane(around))[0]);
    parallelRows(height, kBand, [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        for (int x = 0; x < width; ++x)
          if (!(std::abs(plane.at<float>(y, x) - wanted) <= shape.tolerance)) like.at<uchar>(y, x) = 0;
    });
  }
  if (shape.connected) {
    constexpr int kReached = 128;
    like.at<uchar>(shape.y, shape.x) = 255;
    cv::floodFill(like, {shape.x, shape.y}, kReached, nullptr, {}, {}, 8);
    like = like == kReached;
  }
  cv::medianBlur(like, like, kSpeck);
  cv::Mat soft;
  like.convertTo(soft, CV_32F, 1 / 255.);
  blur(soft, kSoftEdge);
  return rasterOf(soft, {0, 0}, width, height);
}

MaskRaster drawSelection(const SelectionShape& shape, MaskGround& ground) {
  const int width = ground.width(), height = ground.height();
  const PixelRect all{0, 0, width, height};
  PixelRect area;
  std::vector<PreparedMask> parts;
  for (const SelectionPart& part : *shape.parts) {
    parts.emplace_back(Mask{part.shape}, ground);
    if (part.how == SelectionPart::Combine::Add) area = enclosing(area, parts.back().bounds());
  }
  // With room for what is softened.
  area = intersection(area.grown(static_cast<int>(std::ceil(shape.feather)) + 2), all);
  if (area.empty()) return {width, height};
  cv::Mat sum(area.height, area.width, CV_32F, cv::Scalar(0));
  for (size_t i = 0; i < parts.size(); ++i)
    parallelRows(area.height, kBand, [&](int begin, int end) {
      std::vector<float> row(static_cast<size_t>(area.width));
      for (int y = begin; y < end; ++y) {
        parts[i].row(area.x, area.y + y, area.width, row.data());
        combine((*shape.parts)[i].how, row.data(), area.width, sum.ptr<float>(y));
      }
    });
  if (shape.feather > 1) blur(sum, shape.feather / 4.);
  return rasterOf(sum, {area.x, area.y}, width, height);
}

}  // namespace swaplight
