#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/color/chromaticities.h"
#include "core/image/header_values.h"
#include "core/image/pixel_pack.h"
#include "core/image/pixel_rect.h"

namespace swaplight {

/// A channel that is to be written: somebody else's plane, rows without gaps.
struct ChannelToWrite {
  std::string name;
  const float* plane = nullptr;
  PixelType type = PixelType::Half;
};

/// A part of a file; formats other than EXR have one, without a name.
struct PartToWrite {
  std::string name;
  std::vector<ChannelToWrite> channels;
};

/// A file that is to be written, straight from planes that may belong to many images.
struct FileToWrite {
  int width = 0;
  int height = 0;
  std::vector<PartToWrite> parts;
  std::string colorSpace;                   ///< srgb, or one with chromaticities; others are not said
  std::string compression;                  ///< empty: zip for EXR and TIFF
  std::map<std::string, std::string> text;  ///< attributes for the header, the first part's
  int jpegQuality = 95;
  HeaderValues header = {};                    ///< more of them; where `text` has the name, that one holds
  float pixelAspect = 1;                       ///< width over height of a pixel
  std::optional<PixelRect> dataWindow = {};    ///< EXR: the part of the picture that is written, inside of it
  std::vector<unsigned char> iccProfile = {};  ///< PNG, TIFF, JPEG: embedded
  std::optional<Chromaticities> chromaticities =
      {};  ///< EXR: where the colour space's name does not say them

  /// What an EXR says of its primaries and its white.
  [[nodiscard]] std::optional<Chromaticities> saidChromaticities() const {
    return chromaticities ? chromaticities : chromaticitiesOf(colorSpace);
  }

  /// What is written of the picture.
  [[nodiscard]] PixelRect window() const { return dataWindow.value_or(PixelRect{0, 0, width, height}); }
};

}  // namespace swaplight
