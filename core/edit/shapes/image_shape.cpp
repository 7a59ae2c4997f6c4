#include "core/edit/shapes/image_shape.h"

#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/edit/raster/shape_drawing.h"
#include "core/image/io/image_io.h"

namespace swaplight {

MaskRaster ImageShape::draw(int pictureWidth, int pictureHeight) const {
  const Image image = readImage(file).image;
  cv::Mat pixels(image.height(), image.width(), CV_32F);
  const bool color = image.channelCount() >= 3;
  const int alpha = image.channelIndex("A");
  for (int row = 0; row < pixels.rows; ++row)
    for (int column = 0; column < pixels.cols; ++column) {
      const ImageView view = image.view();
      const float luminance = color ? .2126f * view.at(0, column, row) + .7152f * view.at(1, column, row) +
                                          .0722f * view.at(2, column, row)
                                    : view.at(0, column, row);
      pixels.at<float>(row, column) = luminance * (alpha >= 0 ? view.at(alpha, column, row) : 1.f);
    }
  const cv::Size size(width > 0 ? cvRound(width) : pixels.cols, height > 0 ? cvRound(height) : pixels.rows);
  if (size.empty())
    throw InputError("{}: cannot be stretched to {} x {} pixels.", file, size.width, size.height);
  const cv::Point corner(cvRound(x), cvRound(y));
  if (size.width < pixels.cols && size.height < pixels.rows) {
    cv::resize(pixels, pixels, size, 0, 0, cv::INTER_AREA);
    return rasterOf(pixels, corner, pictureWidth, pictureHeight);
  }
  return stretched(pixels, size, corner, pictureWidth, pictureHeight);
}

}  // namespace swaplight
