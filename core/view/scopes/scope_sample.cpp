#include "core/view/scopes/scope_sample.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/color/srgb.h"
#include "core/view/layer_sum.h"

namespace swaplight {
namespace {

int rowsOf(const PictureRegion& region, int maxPixels) {
  return std::clamp(maxPixels / region.width, 1, region.height);
}

/// The row of the region that is the sample's `row`-th of `rows`.
int sampledRow(int row, int rows, const PictureRegion& region) {
  return static_cast<int>((2 * int64_t{row} + 1) * region.height / (2 * int64_t{rows}));
}

}  // namespace

ScopeSample scopeSample(std::span<const ViewLayer> layers, const PictureRegion& region,
                        const DisplayTable& table, int maxPixels) {
  ScopeSample sample;
  if (layers.empty() || region.width <= 0 || region.height <= 0) return sample;
  std::vector<VisibleLayer> visible;
  visible.reserve(layers.size());
  for (const ViewLayer& layer : layers)
    visible.emplace_back(layer,
                         layer.picture->level(0).crop(region.x, region.y, region.width, region.height));
  LayerSum sum;
  sum.set(std::move(visible));
  const int rows = rowsOf(region, maxPixels);
  sample.linear = Image(ImageSpec::rgb(region.width, rows));
  sample.codes.resize(sample.linear.pixelCount() * 4);
  parallelRows(rows, 8, [&](int begin, int end) {
    const ImageSpan linear = sample.linear.span();
    for (int row = begin; row < end; ++row) {
      const int y = sampledRow(row, rows, region);
      for (int c = 0; c < 3; ++c) sum.row(c, y, linear.row(c, row));
      table.apply(linear.row(0, row), linear.row(1, row), linear.row(2, row), region.width,
                  sample.codes.data() + 4 * static_cast<ptrdiff_t>(row) * region.width);
    }
  });
  return sample;
}

ScopeSample scopeSampleOfCodes(ImageView codes, const PictureRegion& region, int maxPixels) {
  ScopeSample sample;
  if (region.width <= 0 || region.height <= 0) return sample;
  const int rows = rowsOf(region, maxPixels);
  sample.linear = Image(ImageSpec::rgb(region.width, rows));
  sample.codes.assign(sample.linear.pixelCount() * 4, 255);
  parallelRows(rows, 8, [&](int begin, int end) {
    const ImageSpan linear = sample.linear.span();
    for (int row = begin; row < end; ++row) {
      const int y = region.y + sampledRow(row, rows, region);
      uint8_t* out = sample.codes.data() + 4 * static_cast<ptrdiff_t>(row) * region.width;
      for (int c = 0; c < 3; ++c)
        for (int x = 0; x < region.width; ++x) {
          const float code = std::clamp(codes.at(c, region.x + x, y), 0.0F, 1.0F);
          linear.at(c, x, row) = linearFromSrgb(code);
          out[4 * x + c] = static_cast<uint8_t>(std::lround(255 * code));
        }
    }
  });
  return sample;
}

}  // namespace swaplight
