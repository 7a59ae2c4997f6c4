#include "core/plot/plot_canvas.h"

#include <array>
#include <opencv2/imgproc.hpp>

#include "core/plot/text_drawing.h"

namespace swaplight {
namespace {

constexpr int kShift = 4;  // OpenCV draws at 1/16 of a pixel

cv::Point fixed(cv::Point2d p) {
  return {cvRound(p.x * (1 << kShift)), cvRound(p.y * (1 << kShift))};
}

}  // namespace

const cv::Scalar PlotCanvas::kInk(38, 38, 44);
const cv::Scalar PlotCanvas::kGrid(226, 226, 230);
const cv::Scalar PlotCanvas::kFrame(120, 120, 128);

cv::Scalar PlotCanvas::seriesColor(size_t index) {
  static const std::array<cv::Scalar, 10> colors = {
      cv::Scalar(0, 114, 178),  cv::Scalar(213, 94, 0),  cv::Scalar(0, 158, 115), cv::Scalar(204, 121, 167),
      cv::Scalar(86, 180, 233), cv::Scalar(180, 130, 0), cv::Scalar(90, 90, 90),  cv::Scalar(130, 20, 60),
      cv::Scalar(90, 60, 160),  cv::Scalar(60, 110, 20)};
  return colors[index % colors.size()];
}

PlotCanvas::PlotCanvas(PlotSize size) : m_pixels(size.height, size.width, CV_8UC3, cv::Scalar::all(255)) {}

void PlotCanvas::text(const std::string& words, cv::Point2d middle, TextAnchor anchor, int height,
                      const cv::Scalar& color) {
  const double width = textSize(words, height).width;
  const double left = middle.x - (anchor == TextAnchor::Left     ? 0
                                  : anchor == TextAnchor::Center ? width / 2
                                                                 : width);
  // A capital letter stands about .73 of the line high: its middle goes to the point.
  drawText(m_pixels, words, {cvRound(left), cvRound(middle.y + .36 * height)}, height, color);
}

void PlotCanvas::verticalText(const std::string& words, cv::Point middle, int height) {
  PlotCanvas strip({textSize(words, height).width + 8, height * 3 / 2});
  strip.text(words, {strip.m_pixels.cols / 2., strip.m_pixels.rows / 2.}, TextAnchor::Center, height);
  cv::Mat turned;
  cv::rotate(strip.m_pixels, turned, cv::ROTATE_90_COUNTERCLOCKWISE);
  const cv::Rect target = cv::Rect({middle.x - turned.cols / 2, middle.y - turned.rows / 2}, turned.size());
  const cv::Rect visible = target & bounds();
  turned(visible - target.tl()).copyTo(m_pixels(visible));
}

void PlotCanvas::line(cv::Point2d from, cv::Point2d to, const cv::Scalar& color, int thickness) {
  cv::line(m_pixels, fixed(from), fixed(to), color, thickness, cv::LINE_AA, kShift);
}

void PlotCanvas::rectangle(cv::Rect2d box, const cv::Scalar& fill, const cv::Scalar& edge) {
  cv::rectangle(m_pixels, fixed(box.tl()), fixed(box.br()), fill, cv::FILLED, cv::LINE_AA, kShift);
  cv::rectangle(m_pixels, fixed(box.tl()), fixed(box.br()), edge, 1, cv::LINE_AA, kShift);
}

void PlotCanvas::dot(cv::Point2d center, double radius, const cv::Scalar& color) {
  cv::circle(m_pixels, fixed(center), cvRound(radius * (1 << kShift)), color, cv::FILLED, cv::LINE_AA,
             kShift);
}

void PlotCanvas::diamond(cv::Point2d center, double radius, const cv::Scalar& color) {
  const std::array<cv::Point, 4> corners = {
      fixed(center + cv::Point2d(0, -radius)), fixed(center + cv::Point2d(radius, 0)),
      fixed(center + cv::Point2d(0, radius)), fixed(center + cv::Point2d(-radius, 0))};
  cv::fillConvexPoly(m_pixels, corners.data(), 4, color, cv::LINE_AA, kShift);
}

Image PlotCanvas::image() const {
  Image result(ImageSpec{m_pixels.cols, m_pixels.rows, {"R", "G", "B"}, "srgb"});
  for (int y = 0; y < m_pixels.rows; ++y) {
    const uchar* in = m_pixels.ptr(y);
    for (int x = 0; x < m_pixels.cols; ++x)
      for (int c = 0; c < 3; ++c) result.span().at(c, x, y) = static_cast<float>(in[3 * x + c]) / 255.f;
  }
  return result;
}

}  // namespace swaplight
