#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/plot/plot_axis.h"

namespace swaplight {

enum class TextAnchor { Left, Center, Right };

/// What plots draw on: a white picture with text, lines and markers at sub-pixel positions. Colours are RGB,
/// 0..255.
class PlotCanvas {
 public:
  explicit PlotCanvas(PlotSize size);

  void text(const std::string& words, cv::Point2d middle, TextAnchor anchor, int height,
            const cv::Scalar& color = kInk);
  /// Reads upwards, centred on a point.
  void verticalText(const std::string& words, cv::Point middle, int height);
  void line(cv::Point2d from, cv::Point2d to, const cv::Scalar& color, int thickness = 1);
  void rectangle(cv::Rect2d box, const cv::Scalar& fill, const cv::Scalar& edge);
  void dot(cv::Point2d center, double radius, const cv::Scalar& color);
  void diamond(cv::Point2d center, double radius, const cv::Scalar& color);

  [[nodiscard]] Image image() const;
  [[nodiscard]] cv::Rect bounds() const { return {0, 0, m_pixels.cols, m_pixels.rows}; }

  static const cv::Scalar kInk, kGrid, kFrame;
  /// Distinct colours for series, by index (Okabe and Ito's set, told apart with any colour vision).
  static cv::Scalar seriesColor(size_t index);

 private:
  cv::Mat m_pixels;  // 8-bit RGB
};

/// A plot's rectangle with its axes.
class PlotFrame {
 public:
  /// Lays the axes out in `outer` and draws title, grid, ticks and labels. Without an x scale, columns are
  /// named by the plot itself and `columnsHeight` pixels are kept for them.
  PlotFrame(PlotCanvas& canvas, cv::Rect outer, const std::string& title, const AxisScale* x,
            const AxisScale& y, int columnsHeight = 0);
  [[nodiscard]] cv::Rect inner() const { return m_inner; }
  [[nodiscard]] double yPixel(double value) const;
  [[nodiscard]] cv::Point2d at(double x, double y) const;

 private:
  cv::Rect m_inner;
  AxisScale m_x, m_y;
};

constexpr int kTextHeight = 16;
constexpr int kTitleHeight = 20;

}  // namespace swaplight
