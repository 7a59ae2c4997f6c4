#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/image/io/image_io.h"
#include "core/image/io/image_write.h"

namespace swaplight {

/// What a photograph's file holds beside its colour (timecode, lens, mattes, depth ...): handed on to the
/// files that are made of it.
struct CarriedData {
  HeaderValues header;
  float pixelAspect = 1;
  std::optional<PixelRect> dataWindow;  ///< where it is smaller than the picture: nothing is known outside
  Image channels;                       ///< of the picture's size, under the names they had; may be empty
  std::vector<PixelType> types;         ///< of each channel, half or float

  /// A channel as it is to be written.
  [[nodiscard]] ChannelToWrite channel(int index) const;
};

/// What a file holds beside the channels `used`. Nothing where there is nothing worth carrying.
[[nodiscard]] std::shared_ptr<CarriedData> carriedData(const Image& image, const ImageFileInfo& info,
                                                       std::span<const int> used);

/// The data window of a picture that was made of another: what the other's holds, and all that is not 0.
[[nodiscard]] PixelRect windowWithLight(const PixelRect& window, const Image& image);

/// Puts the header and the aspect into a file; with `channels` also the data window, and the channels into
/// its first part, where no channel has that name already. Only an EXR holds those.
void addCarried(FileToWrite& contents, const CarriedData& carried, bool channels = true);

}  // namespace swaplight
