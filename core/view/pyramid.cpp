#include "core/view/pyramid.h"

#include <algorithm>
#include <string>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr int kSmallestSide = 64;

void halveRow(const float* upper, const float* lower, int width, float* out) {
  const int pairs = width / 2;
  for (int x = 0; x < pairs; ++x)
    out[x] = 0.25F * (upper[2 * x] + upper[2 * x + 1] + lower[2 * x] + lower[2 * x + 1]);
  if (width % 2 != 0) out[pairs] = 0.5F * (upper[width - 1] + lower[width - 1]);
}

/// `out` has half the size of `image`, rounded up.
void halveInto(ImageView image, ImageSpan out) {
  parallelRows(out.height, 32, [&](int begin, int end) {
    for (int c = 0; c < out.channels; ++c)
      for (int y = begin; y < end; ++y)
        halveRow(image.row(c, 2 * y), image.row(c, std::min(2 * y + 1, image.height - 1)), image.width,
                 out.row(c, y));
  });
}

}  // namespace

Image halveImage(ImageView image) {
  ImageSpec spec{(image.width + 1) / 2, (image.height + 1) / 2, {}, "data"};
  for (int c = 0; c < image.channels; ++c) spec.channels.push_back(std::to_string(c));
  Image half(std::move(spec));
  halveInto(image, half.span());
  return half;
}

Pyramid::Pyramid(ImageView picture) : m_picture(picture) {
  ImageView last = picture;
  while (std::max(last.width, last.height) > kSmallestSide) {
    m_halves.push_back(halveImage(last));
    last = m_halves.back().view();
  }
}

void Pyramid::refresh(int x, int y, int width, int height) {
  ImageView upper = m_picture;
  int right = x + width, bottom = y + height;
  for (Image& half : m_halves) {
    x /= 2;
    y /= 2;
    right = std::min((right + 1) / 2, half.width());
    bottom = std::min((bottom + 1) / 2, half.height());
    const int upperWidth = std::min(2 * right, upper.width) - 2 * x;
    const int upperHeight = std::min(2 * bottom, upper.height) - 2 * y;
    halveInto(upper.crop(2 * x, 2 * y, upperWidth, upperHeight),
              half.span().crop(x, y, right - x, bottom - y));
    upper = half.view();
  }
}

}  // namespace swaplight
