#include "core/view/scopes/scope_sample.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/view/layer_sum.h"

namespace swaplight {

ScopeSample scopeSample(std::span<const ViewLayer> layers, const PictureRegion& region,
                        const DisplayTable& table, int maxPixels) {
  ScopeSample sample;
  if (layers.empty() || region.width <= 0 || region.height <= 0) return sample;
  std::vector<VisibleLayer> visible;
  visible.reserve(layers.size());
  for (const ViewLayer& layer : layers)
    visible.push_back(
        {layer.picture->level(0).crop(region.x, region.y, region.width, region.height), layer.factor});
  LayerSum sum;
  sum.set(std::move(visible));
  const int rows = std::clamp(maxPixels / region.width, 1, region.height);
  sample.linear = Image(ImageSpec::rgb(region.width, rows));
  sample.codes.resize(sample.linear.pixelCount() * 4);
  parallelRows(rows, 8, [&](int begin, int end) {
    const ImageSpan linear = sample.linear.span();
    for (int row = begin; row < end; ++row) {
      const auto y = static_cast<int>((2 * int64_t{row} + 1) * region.height / (2 * int64_t{rows}));
      for (int c = 0; c < 3; ++c) sum.row(c, y, linear.row(c, row));
      table.apply(linear.row(0, row), linear.row(1, row), linear.row(2, row), region.width,
                  sample.codes.data() + 4 * static_cast<ptrdiff_t>(row) * region.width);
    }
  });
  return sample;
}

}  // namespace swaplight
