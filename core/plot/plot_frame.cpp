#include <algorithm>
#include <cmath>

#include "core/plot/plot_canvas.h"
#include "core/plot/text_drawing.h"

namespace swaplight {

PlotFrame::PlotFrame(PlotCanvas& canvas, cv::Rect outer, const std::string& title, const AxisScale* x,
                     const AxisScale& y, int columnsHeight)
    : m_x(x ? *x : AxisScale{}), m_y(y) {
  // Lay out.
  int tickWidth = 0;
  for (const double t : y.ticks) tickWidth = std::max(tickWidth, textSize(tickText(t), kTextHeight).width);
  const int left = tickWidth + 14 + (y.label.empty() ? 0 : kTextHeight * 2);
  const int bottom = x ? kTextHeight * 2 + (x->label.empty() ? 0 : kTextHeight * 3 / 2) : columnsHeight + 8;
  const int top = title.empty() ? 14 : kTitleHeight * 2 + 6;
  m_inner = {outer.x + left, outer.y + top, std::max(outer.width - left - 24, 10),
             std::max(outer.height - top - bottom, 10)};

  // Grid, ticks, labels.
  canvas.text(title, {m_inner.x + m_inner.width / 2., outer.y + top / 2.}, TextAnchor::Center, kTitleHeight);
  for (const double t : m_y.ticks) {
    const double pixel = yPixel(t);
    canvas.line({m_inner.x + 0., pixel}, {m_inner.br().x + 0., pixel}, PlotCanvas::kGrid);
    canvas.text(tickText(t), {m_inner.x - 8., pixel}, TextAnchor::Right, kTextHeight);
  }
  if (!y.label.empty())
    canvas.verticalText(y.label, {outer.x + kTextHeight, m_inner.y + m_inner.height / 2}, kTextHeight);
  if (x) {
    double written = -INFINITY;  // right end of the last tick's text: texts never touch
    for (const double t : x->ticks) {
      const double pixel = m_inner.x + x->fraction(t) * m_inner.width;
      canvas.line({pixel, m_inner.y + 0.}, {pixel, m_inner.br().y + 0.}, PlotCanvas::kGrid);
      const double half = textSize(tickText(t), kTextHeight).width / 2.;
      if (pixel - half < written + 8) continue;
      canvas.text(tickText(t), {pixel, m_inner.br().y + kTextHeight * .9}, TextAnchor::Center, kTextHeight);
      written = pixel + half;
    }
    canvas.text(x->label, {m_inner.x + m_inner.width / 2., m_inner.br().y + kTextHeight * 2.4},
                TextAnchor::Center, kTextHeight);
  }
  canvas.line(m_inner.tl(), {m_inner.x + 0., m_inner.br().y + 0.}, PlotCanvas::kFrame);
  canvas.line({m_inner.x + 0., m_inner.br().y + 0.}, m_inner.br(), PlotCanvas::kFrame);
}

double PlotFrame::yPixel(double value) const {
  return m_inner.br().y - m_y.fraction(value) * m_inner.height;
}

cv::Point2d PlotFrame::at(double x, double y) const {
  return {m_inner.x + m_x.fraction(x) * m_inner.width, yPixel(y)};
}

}  // namespace swaplight
