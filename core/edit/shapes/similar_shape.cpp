#include "core/edit/shapes/similar_shape.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/parallel.h"
#include "core/edit/fields/field_json.h"
#include "core/edit/raster/shape_drawing.h"
#include "core/file/json_fields.h"

namespace swaplight {
namespace {

constexpr int kBand = 32;
constexpr int kSpeck = 5;         // pixels: the side of the median that takes specks away
constexpr double kSoftEdge = .8;  // sigma, so that the edge is no staircase

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

}  // namespace

void SimilarShape::writeMore(Json& json) const {
  json["at"] = {x, y};
  json["connected"] = connected;
}

void SimilarShape::readMore(JsonFields& fields, int /*width*/, int /*height*/) {
  const Json* at = fields.find("at");
  if (!at) throw InputError("{}: \"at\" is missing, expected [x, y].", fields.where());
  const auto pixel = pixelFromJson(*at, fields.where() + ": at");
  x = pixel[0];
  y = pixel[1];
  connected = fields.boolean("connected").value_or(true);
}

MaskRaster SimilarShape::draw(const SolvedSet& set) const {
  const int width = set.width(), height = set.height();
  if (x < 0 || y < 0 || x >= width || y >= height)
    throw InputError("\"similar\": the place {}, {} is outside the picture of {} x {}.", x, y, width, height);
  const cv::Rect around = cv::Rect(x - 2, y - 2, 5, 5) & cv::Rect(0, 0, width, height);
  cv::Mat like(height, width, CV_8U, cv::Scalar(255));
  for (const cv::Mat& plane : comparedPlanes(*this, set)) {
    const auto wanted = static_cast<float>(cv::mean(plane(around))[0]);
    parallelRows(height, kBand, [&](int begin, int end) {
      for (int row = begin; row < end; ++row)
        for (int column = 0; column < width; ++column)
          if (!(std::abs(plane.at<float>(row, column) - wanted) <= tolerance))
            like.at<uchar>(row, column) = 0;
    });
  }
  if (connected) {
    constexpr int kReached = 128;
    like.at<uchar>(y, x) = 255;
    cv::floodFill(like, {x, y}, kReached, nullptr, {}, {}, 8);
    like = like == kReached;
  }
  cv::medianBlur(like, like, kSpeck);
  cv::Mat soft;
  like.convertTo(soft, CV_32F, 1 / 255.);
  blurMask(soft, kSoftEdge);
  return rasterOf(soft, {0, 0}, width, height);
}

}  // namespace swaplight
