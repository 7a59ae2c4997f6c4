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

// Softer than so many pixels of sigma, a shape is drawn in a smaller picture: that is as smooth, and costs
// neither the time nor the memory of a picture that is a feather larger on all sides. OpenCV's outline is
// half a pixel of that picture too far out: 1/64 of the sigma at most.
constexpr float kMostSigma = 32;

float diagonal(int width, int height) {
  return std::hypot(static_cast<float>(width), static_cast<float>(height));
}

/// A row of a picture stretched to `size`, between its pixels, as cv::resize does it.
void stretchedRow(const cv::Mat& from, const cv::Size& size, int y, int left, std::vector<float>& out) {
  const auto place = [](int at, int count, int stretched, int& first, int& second) {
    const double exact = (at + .5) * count / stretched - .5;
    const double clamped = std::clamp(exact, 0., count - 1.);
    first = static_cast<int>(clamped);
    second = std::min(first + 1, count - 1);
    return static_cast<float>(clamped - first);
  };
  int top = 0, bottom = 0;
  const float down = place(y, from.rows, size.height, top, bottom);
  for (size_t i = 0; i < out.size(); ++i) {
    int a = 0, b = 0;
    const float across = place(left + static_cast<int>(i), from.cols, size.width, a, b);
    const auto mixed = [&](const float* row) { return row[a] + across * (row[b] - row[a]); };
    const float upper = mixed(from.ptr<float>(top));
    out[i] = upper + down * (mixed(from.ptr<float>(bottom)) - upper);
  }
}

/// A picture stretched to `size` with its corner somewhere, as a mask: only what is seen of it is made.
MaskRaster stretched(const cv::Mat& pixels, const cv::Size& size, const cv::Point& corner, int width,
                     int height) {
  MaskRaster raster(width, height);
  const PixelRect seen = intersection({corner.x, corner.y, size.width, size.height}, {0, 0, width, height});
  if (seen.empty()) return raster;
  std::vector<float> row(static_cast<size_t>(seen.width));
  for (int y = seen.y; y < seen.bottom(); ++y) {
    stretchedRow(pixels, size, y - corner.y, seen.x - corner.x, row);
    raster.writeRow(seen.x, y, seen.width, row.data());
  }
  return raster;
}

/// Where a shape is drawn: what can be seen of it, with room for what a feather brings in from outside of the
/// picture, `shrink` times smaller.
struct Canvas {
  float feather;  ///< of the picture; beyond its diagonal there is nothing to see of more
  int shrink = 1;
  PixelRect area;  ///< of the picture; may reach beyond it
  cv::Size size;   ///< of what is drawn; empty where nothing is seen

  /// `box`: around the shape, without its feather.
  Canvas(float wanted, const PixelRect& box, int width, int height)
      : feather(std::clamp(wanted, 0.F, diagonal(width, height))) {
    while (feather / 4 / static_cast<float>(shrink) > kMostSigma) shrink *= 2;
    const int air = cvCeil(feather) + 2 * shrink;
    area = intersection(box.grown(air), {-air, -air, width + 2 * air, height + 2 * air});
    if (!area.empty())
      size = cv::Size((area.width + shrink - 1) / shrink, (area.height + shrink - 1) / shrink);
  }
  /// A point of the picture where pixels have their centres at whole numbers, in OpenCV's fixed point:
  /// whatever a file says.
  [[nodiscard]] cv::Point place(float x, float y) const {
    constexpr float kFarthest = 1e7F;
    const auto fixed = [&](float at, int corner) {
      const float small = (at - static_cast<float>(corner)) / static_cast<float>(shrink) - .5F;
      return cvRound(std::clamp(small, -kFarthest, kFarthest) * (1 << kShift));
    };
    return {fixed(x, area.x), fixed(y, area.y)};
  }
  /// 8 bits to 0..1 with a soft edge, as the mask of the picture.
  [[nodiscard]] MaskRaster soften(const cv::Mat& drawn, int width, int height) const;
};

MaskRaster Canvas::soften(const cv::Mat& drawn, int width, int height) const {
  cv::Mat pixels;
  drawn.convertTo(pixels, CV_32F, 1 / 255.);
  if (feather > 1) cv::GaussianBlur(pixels, pixels, {}, feather / 4. / shrink, 0, cv::BORDER_CONSTANT);
  if (shrink == 1) return rasterOf(pixels, {area.x, area.y}, width, height);
  return stretched(pixels, {size.width * shrink, size.height * shrink}, {area.x, area.y}, width, height);
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
  PixelRect box;
  for (const auto& p : shape.points)
    box = enclosing(box,
                    {cvFloor(std::clamp(p[0], -1e5f, 1e5f)), cvFloor(std::clamp(p[1], -1e5f, 1e5f)), 1, 1});
  const Canvas canvas(shape.feather, box, width, height);
  if (canvas.size.empty()) return {width, height};
  cv::Mat drawn(canvas.size, CV_8U, cv::Scalar(0));
  std::vector<std::vector<cv::Point>> line(1);
  for (const auto& p : shape.points) line[0].push_back(canvas.place(p[0], p[1]));
  cv::fillPoly(drawn, line, cv::Scalar(255), cv::LINE_AA, kShift);
  return canvas.soften(drawn, width, height);
}

MaskRaster drawShape(const TextShape& shape, int width, int height) {
  const float most = diagonal(width, height);
  if (shape.height > most)
    throw InputError("\"text\": its height is {} pixels, in a picture of {} x {}; expected at most {:.0f}.",
                     shape.height, width, height, most);
  // Only as much as the words may cover, with what hangs below the line.
  const int line = std::max(1, cvRound(shape.height));
  const cv::Point baseline(cvRound(shape.x), cvRound(shape.y));
  const PixelRect box{baseline.x - line, baseline.y - 2 * line, textSize(shape.text, line).width + 2 * line,
                      4 * line};
  const Canvas canvas(shape.feather, box, width, height);
  if (canvas.size.empty()) return {width, height};
  cv::Mat drawn(canvas.size, CV_8UC3, cv::Scalar::all(0));
  const cv::Point place((baseline.x - canvas.area.x) / canvas.shrink,
                        (baseline.y - canvas.area.y) / canvas.shrink);
  drawText(drawn, shape.text, place, std::max(1, line / canvas.shrink), cv::Scalar::all(255));
  cv::Mat grey;
  cv::extractChannel(drawn, grey, 0);
  return canvas.soften(grey, width, height);
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
  if (size.empty())
    throw InputError("{}: cannot be stretched to {} x {} pixels.", shape.file, size.width, size.height);
  const cv::Point corner(cvRound(shape.x), cvRound(shape.y));
  if (size.width < pixels.cols && size.height < pixels.rows) {
    cv::resize(pixels, pixels, size, 0, 0, cv::INTER_AREA);
    return rasterOf(pixels, corner, width, height);
  }
  return stretched(pixels, size, corner, width, height);
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
