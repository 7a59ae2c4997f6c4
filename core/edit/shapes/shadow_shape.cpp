#include "core/edit/shapes/shadow_shape.h"

#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/fields/field_json.h"
#include "core/file/json_fields.h"
#include "core/shadow/result/label_mask.h"

namespace swaplight {
namespace {

// The number of the shadow that holds the shape's pixel.
int regionAt(const ShadowShape& shape, const cv::Mat& regions) {
  const bool inside = shape.x >= 0 && shape.y >= 0 && shape.x < regions.cols && shape.y < regions.rows;
  const int region = inside ? regions.at<int>(shape.y, shape.x) : 0;
  if (region == 0)
    throw InputError(
        "there is no shadow of \"{}\" at {}, {}. Choose a pixel within one of its shadows "
        "(`swaplight shadows` draws their outlines).",
        shape.light, shape.x, shape.y);
  return region;
}

// The part of the picture that holds a region and `margin` pixels around it.
cv::Rect areaAround(const cv::Mat& regions, int region, int margin) {
  const cv::Rect box = cv::boundingRect(regions == region);
  const cv::Rect wide(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin);
  return wide & cv::Rect(0, 0, regions.cols, regions.rows);
}

}  // namespace

void ShadowShape::writeMore(Json& json) const {
  json["light"] = light;
  if (region) json["at"] = {x, y};
}

void ShadowShape::readMore(JsonFields& fields, int /*width*/, int /*height*/) {
  light = fields.text("light").value_or("");
  const Json* at = fields.find("at");
  if (!at) return;
  const auto pixel = pixelFromJson(*at, fields.where() + ": at");
  region = true;
  x = pixel[0];
  y = pixel[1];
}

MaskRaster ShadowShape::draw(const LightShadows& shadows) const {
  const Image& visibility = shadows.visibility;
  const int width = visibility.width();
  const int height = visibility.height();
  cv::Mat chosen(height, width, CV_8U, cv::Scalar(1));
  if (region) {
    const cv::Mat regions = shadowRegions(shadows);
    chosen = cv::Mat((regions == regionAt(*this, regions)) / 255);
    cv::dilate(chosen, chosen, {}, {-1, -1}, 2);  // with the faint rim around it
  }
  MaskRaster raster(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      if (chosen.at<uchar>(row, column)) raster.set(column, row, 1 - visibility.view().at(0, column, row));
  return raster;
}

MaskRaster ShadowShape::drawZone(const LightShadows& shadows, int zone) const {
  const cv::Mat regions = shadowRegions(shadows);
  const cv::Rect area = areaAround(regions, regionAt(*this, regions), zone);

  // Each pixel belongs to the shadow that is nearest.
  const cv::Mat lit = regions(area) == 0;
  cv::Mat distance, nearest;
  cv::distanceTransform(lit, distance, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_CCOMP);
  const int own = nearest.at<int>(y - area.y, x - area.x);
  MaskRaster raster(regions.cols, regions.rows);
  for (int row = 0; row < area.height; ++row)
    for (int column = 0; column < area.width; ++column)
      if (nearest.at<int>(row, column) == own && distance.at<float>(row, column) <= static_cast<float>(zone))
        raster.set(area.x + column, area.y + row, 1);
  return raster;
}

}  // namespace swaplight
