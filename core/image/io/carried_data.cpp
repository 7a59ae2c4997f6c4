#include "core/image/io/carried_data.h"

#include <algorithm>
#include <iterator>

namespace swaplight {

namespace {

/// What a data window holds of a picture, where that is not all of it.
std::optional<PixelRect> smallerWindow(const std::optional<PixelRect>& window, int width, int height) {
  const PixelRect whole{0, 0, width, height};
  const PixelRect held = intersection(window.value_or(whole), whole);
  return held == whole ? std::nullopt : std::optional(held);
}

}  // namespace

ChannelToWrite CarriedData::channel(int index) const {
  const auto i = static_cast<size_t>(index);
  return {channels.spec().channels[i], channels.plane(index), types[i]};
}

std::shared_ptr<CarriedData> carriedData(const Image& image, const ImageFileInfo& info,
                                         std::span<const int> used) {
  auto carried = std::make_shared<CarriedData>();
  carried->header = info.header;
  carried->pixelAspect = info.pixelAspect;
  carried->dataWindow = smallerWindow(info.dataWindow, image.width(), image.height());
  std::vector<int> others;
  for (int c = 0; c < image.channelCount(); ++c)
    if (std::find(used.begin(), used.end(), c) == used.end()) others.push_back(c);
  ImageSpec spec{image.width(), image.height(), {}, "data"};
  for (const int c : others) {
    spec.channels.push_back(image.spec().channels[static_cast<size_t>(c)]);
    const bool half = info.channelTypes.at(static_cast<size_t>(c)) == PixelType::Half;
    carried->types.push_back(half ? PixelType::Half : PixelType::Float);
  }
  if (!others.empty()) {
    carried->channels = Image(spec);
    for (size_t i = 0; i < others.size(); ++i)
      std::copy_n(image.plane(others[i]), image.pixelCount(), carried->channels.plane(static_cast<int>(i)));
  }
  const bool plain =
      carried->header.empty() && carried->pixelAspect == 1 && !carried->dataWindow && others.empty();
  return plain ? nullptr : carried;
}

PixelRect windowWithLight(const PixelRect& window, const Image& image) {
  PixelRect all = window;
  for (int c = 0; c < image.channelCount(); ++c)
    for (int y = 0; y < image.height(); ++y) {
      const float* row = image.view().row(c, y);
      const float* end = row + image.width();
      const auto isLit = [](float value) { return value != 0; };
      const float* first = std::find_if(row, end, isLit);
      if (first == end) continue;
      const float* last =
          std::find_if(std::reverse_iterator(end), std::reverse_iterator(first), isLit).base();
      all = enclosing(all, {int(first - row), y, int(last - first), 1});
    }
  return all;
}

void addCarried(FileToWrite& contents, const CarriedData& carried, bool channels) {
  contents.header.insert(carried.header.begin(), carried.header.end());
  contents.pixelAspect = carried.pixelAspect;
  if (!channels) return;
  if (!contents.dataWindow)
    contents.dataWindow = smallerWindow(carried.dataWindow, contents.width, contents.height);
  const auto isThere = [&](const std::string& name) {
    return std::any_of(contents.parts.begin(), contents.parts.end(), [&](const PartToWrite& part) {
      return std::any_of(part.channels.begin(), part.channels.end(),
                         [&](const ChannelToWrite& channel) { return channel.name == name; });
    });
  };
  for (int c = 0; c < carried.channels.channelCount(); ++c)
    if (!isThere(carried.channels.spec().channels[static_cast<size_t>(c)]))
      contents.parts.front().channels.push_back(carried.channel(c));
}

}  // namespace swaplight
