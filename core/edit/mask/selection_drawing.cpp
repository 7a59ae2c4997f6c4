#include "core/edit/mask/selection_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/parallel.h"
#include "core/edit/mask/prepared_mask.h"
#include "core/edit/raster/shape_drawing.h"

namespace swaplight {
namespace {

constexpr int kBand = 32;

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

MaskRaster drawSelection(const SelectionShape& shape, MaskContext& context) {
  const int width = context.width(), height = context.height();
  const PixelRect all{0, 0, width, height};
  PixelRect area;
  std::vector<PreparedMask> parts;
  for (const SelectionPart& part : *shape.parts) {
    parts.emplace_back(Mask{part.shape}, context);
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
  if (shape.feather > 1) blurMask(sum, shape.feather / 4.);
  return rasterOf(sum, {area.x, area.y}, width, height);
}

}  // namespace swaplight
