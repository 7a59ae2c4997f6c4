#include "core/edit/mask/mask_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/image/io/image_io.h"
#include "core/plot/text_drawing.h"
#include "core/shadow/result/label_mask.h"

namespace swaplight {
namespace {

constexpr int kShift = 4;  // OpenCV draws at 1/16 of a pixel

// 8 bits to 0..1, with a soft edge.
cv::Mat softened(const cv::Mat& drawn, float feather) {
  cv::Mat pixels;
  drawn.convertTo(pixels, CV_32F, 1 / 255.);
  if (feather > 1) cv::GaussianBlur(pixels, pixels, {}, feather / 4., 0, cv::BORDER_CONSTANT);
  return pixels;
}

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

MaskRaster rasterOf(const cv::Mat& pixels, cv::Point corner, int width, int height) {
  MaskRaster raster(width, height);
  const PixelRect area = intersection({corner.x, corner.y, pixels.cols, pixels.rows}, {0, 0, width, height});
  for (int y = area.y; y < area.bottom(); ++y)
    raster.writeRow(corner.x, y, pixels.cols, pixels.ptr<float>(y - corner.y));
  return raster;
}

MaskRaster drawShape(const PolygonShape& shape, int width, int height) {
  if (shape.points.size() < 3) return {width, height};
  const int air = cvCeil(shape.feather) + 2;
  PixelRect box;
  for (const auto& p : shape.points)
    box = enclosing(box,
                    {cvFloor(std::clamp(p[0], -1e5f, 1e5f)), cvFloor(std::clamp(p[1], -1e5f, 1e5f)), 1, 1});
  const PixelRect area = intersection(box.grown(air), {-air, -air, width + 2 * air, height + 2 * air});
  if (area.empty()) return {width, height};
  cv::Mat drawn(area.height, area.width, CV_8U, cv::Scalar(0));
  std::vector<std::vector<cv::Point>> line(1);
  for (const auto& p : shape.points)
    line[0].emplace_back(cvRound((p[0] - static_cast<float>(area.x) - .5f) * (1 << kShift)),
                         cvRound((p[1] - static_cast<float>(area.y) - .5f) * (1 << kShift)));
  cv::fillPoly(drawn, line, cv::Scalar(255), cv::LINE_AA, kShift);
  return rasterOf(softened(drawn, shape.feather), {area.x, area.y}, width, height);
}

MaskRaster drawShape(const TextShape& shape, int width, int height) {
  // Only as much as the words may cover, with what hangs below the line and what is softened.
  const int line = std::max(1, cvRound(shape.height));
  const int air = line + cvCeil(shape.feather);
  const cv::Point baseline(cvRound(shape.x), cvRound(shape.y));
  const PixelRect area = intersection({baseline.x - air, baseline.y - line - air,
                                       textSize(shape.text, line).width + 2 * air, 2 * line + 2 * air},
                                      {-air, -air, width + 2 * air, height + 2 * air});
  if (area.empty()) return {width, height};
  cv::Mat drawn(area.height, area.width, CV_8UC3, cv::Scalar::all(0));
  drawText(drawn, shape.text, {baseline.x - area.x, baseline.y - area.y}, line, cv::Scalar::all(255));
  cv::Mat grey;
  cv::extractChannel(drawn, grey, 0);
  return rasterOf(softened(grey, shape.feather), {area.x, area.y}, width, height);
}

MaskRaster drawShape(const PictureShape& shape, int width, int height) {
  const Image picture = readImage(shape.file).image;
  cv::Mat pixels(picture.height(), picture.width(), CV_32F);
  const bool color = picture.channelCount() >= 3;
  const int alpha = picture.channelIndex("A");
  for (int y = 0; y < pixels.rows; ++y)
    for (int x = 0; x < pixels.cols; ++x) {
      const ImageView view = picture.view();
      const float luminance =
          color ? .2126f * view.at(0, x, y) + .7152f * view.at(1, x, y) + .0722f * view.at(2, x, y)
                : view.at(0, x, y);
      pixels.at<float>(y, x) = luminance * (alpha >= 0 ? view.at(alpha, x, y) : 1.f);
    }
  const cv::Size size(shape.width > 0 ? cvRound(shape.width) : pixels.cols,
                      shape.height > 0 ? cvRound(shape.height) : pixels.rows);
  if (size.empty() || size.width > 1 << 16 || size.height > 1 << 16)
    throw InputError("{}: cannot be stretched to {} x {} pixels.", shape.file, size.width, size.height);
  cv::Mat stretched;
  const bool smaller = size.width < pixels.cols && size.height < pixels.rows;
  cv::resize(pixels, stretched, size, 0, 0, smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
  return rasterOf(stretched, {cvRound(shape.x), cvRound(shape.y)}, width, height);
}

MaskRaster drawShape(const ShadowShape& shape, const LightShadows& shadows) {
  const Image& visibility = shadows.visibility;
  const int width = visibility.width();
  const int height = visibility.height();
  cv::Mat chosen(height, width, CV_8U, cv::Scalar(1));
  if (shape.region) {
    const cv::Mat regions = shadowRegions(shadows);
    chosen = cv::Mat((regions == regionAt(shape, regions)) / 255);
    cv::dilate(chosen, chosen, {}, {-1, -1}, 2);  // with the faint rim around it
  }
  MaskRaster raster(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (chosen.at<uchar>(y, x)) raster.set(x, y, 1 - visibility.view().at(0, x, y));
  return raster;
}

MaskRaster drawShadowZone(const ShadowShape& shape, const LightShadows& shadows, int zone) {
  const cv::Mat regions = shadowRegions(shadows);
  const int region = regionAt(shape, regions);
  const cv::Rect area = areaAround(regions, region, zone);

  // Each pixel belongs to the shadow that is nearest.
  const cv::Mat lit = regions(area) == 0;
  cv::Mat distance, nearest;
  cv::distanceTransform(lit, distance, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_CCOMP);
  const int own = nearest.at<int>(shape.y - area.y, shape.x - area.x);
  MaskRaster raster(regions.cols, regions.rows);
  for (int y = 0; y < area.height; ++y)
    for (int x = 0; x < area.width; ++x)
      if (nearest.at<int>(y, x) == own && distance.at<float>(y, x) <= static_cast<float>(zone))
        raster.set(area.x + x, area.y + y, 1);
  return raster;
}

}  // namespace swaplight
