#include "core/image/layer_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/image/half.h"

namespace swaplight {
namespace {

constexpr int kSumGrain = 64;  // rows

}  // namespace

bool fitsHalf(const Image& image) {
  for (int c = 0; c < image.channelCount(); ++c)
    if (!fitsHalf(image.plane(c), image.pixelCount())) return false;
  return true;
}

bool isDarkerThan(double mean, std::span<const Image* const> images) {
  constexpr size_t kStep = 16;
  double sum = 0;
  size_t count = 0;
  for (const Image* image : images) {
    count = 0;
    for (int c = 0; c < std::min(image->channelCount(), 3); ++c)
      for (size_t p = 0; p < image->pixelCount(); p += kStep, ++count)
        if (const float value = image->plane(c)[p]; std::isfinite(value)) sum += double{std::abs(value)};
  }
  return sum > 0 && sum < mean * double(count);
}

PixelType typeThatHolds(std::span<const Image> images, PixelType asked) {
  const auto fits = [](const Image& image) { return fitsHalf(image); };
  if (asked == PixelType::Half && !std::all_of(images.begin(), images.end(), fits)) return PixelType::Float;
  return asked;
}

Image sumOfLayers(std::span<const Image* const> layers, PixelType type) {
  Image sum(ImageSpec::rgb(layers.front()->width(), layers.front()->height()), 0);
  parallelRows(sum.height(), kSumGrain, [&](int begin, int end) {
    const ptrdiff_t first = ptrdiff_t{begin} * sum.width();
    const ptrdiff_t count = ptrdiff_t{end} * sum.width() - first;
    for (const Image* layer : layers)
      for (int c = 0; c < 3; ++c) {
        float* out = sum.plane(c) + first;
        const float* in = layer->plane(c) + first;
        if (type == PixelType::Half)
          for (ptrdiff_t p = 0; p < count; ++p) out[p] += roundedToHalf(in[p]);
        else
          for (ptrdiff_t p = 0; p < count; ++p) out[p] += in[p];
      }
  });
  return sum;
}

PartToWrite imagePart(const std::string& name, const Image& image, std::span<const std::string> channels,
                      PixelType type) {
  PartToWrite part{name, {}};
  for (size_t c = 0; c < channels.size(); ++c)
    part.channels.push_back({channels[c], image.plane(static_cast<int>(c)), type});
  return part;
}

PartToWrite colorPart(const std::string& name, const Image& picture, PixelType type) {
  return imagePart(name, picture, std::array<std::string, 3>{"R", "G", "B"}, type);
}

PartToWrite mergedParts(std::span<const PartToWrite> parts) {
  PartToWrite all;
  for (const PartToWrite& part : parts) {
    const bool plain = &part == parts.data() && part.name == kSumPart;
    for (ChannelToWrite channel : part.channels) {
      if (!plain) channel.name = part.name + "." + channel.name;
      all.channels.push_back(std::move(channel));
    }
  }
  return all;
}

}  // namespace swaplight
