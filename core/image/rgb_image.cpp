#include "core/image/rgb_image.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "core/base/error.h"

namespace swaplight {
namespace {

using Triple = std::array<int, 3>;

std::optional<Triple> named(const Image& image, const std::string& r, const std::string& g,
                            const std::string& b) {
  const Triple found = {image.channelIndex(r), image.channelIndex(g), image.channelIndex(b)};
  if (*std::min_element(found.begin(), found.end()) < 0) return std::nullopt;
  return found;
}

/// R, G, B of the only layer that has them.
std::optional<Triple> ofOnlyLayer(const Image& image) {
  std::optional<Triple> found;
  for (const std::string& channel : image.spec().channels) {
    if (!channel.ends_with(".R")) continue;
    const std::string layer = channel.substr(0, channel.size() - 1);
    const auto triple = named(image, layer + "R", layer + "G", layer + "B");
    if (triple && found) return std::nullopt;
    if (triple) found = triple;
  }
  return found;
}

std::optional<Triple> grey(const Image& image) {
  const std::vector<std::string>& channels = image.spec().channels;
  const bool alphaOnly = channels.size() == 2 && (channels[1] == "A" || channels[1] == "alpha");
  if (channels.size() == 1 || alphaOnly) return Triple{0, 0, 0};
  return std::nullopt;
}

}  // namespace

std::array<int, 3> rgbChannels(const Image& image, const std::filesystem::path& file) {
  std::optional<Triple> from = named(image, "R", "G", "B");
  if (!from) from = named(image, "r", "g", "b");
  if (!from) from = ofOnlyLayer(image);
  if (!from) from = grey(image);
  if (!from)
    throw InputError("{}: has the channels {}, expected R, G, B or grey. Export the picture's colour.",
                     file.string(), fmt::join(image.spec().channels, ", "));
  return *from;
}

Image rgbImage(Image&& image, const std::filesystem::path& file) {
  if (image.spec().channels == std::vector<std::string>{"R", "G", "B"}) return std::move(image);
  const Triple from = rgbChannels(image, file);
  ImageSpec spec = ImageSpec::rgb(image.width(), image.height());
  spec.colorSpace = image.spec().colorSpace;
  Image rgb(std::move(spec));
  for (int c = 0; c < 3; ++c)
    std::copy_n(image.plane(from[static_cast<size_t>(c)]), image.pixelCount(), rgb.plane(c));
  return rgb;
}

}  // namespace swaplight
