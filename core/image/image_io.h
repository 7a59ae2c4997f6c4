#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// What a file says beside its pixels.
struct ImageFileInfo {
  std::string format;     ///< openexr, png, tiff, jpeg, hdr, raw
  std::string pixelType;  ///< half, float, uint8, uint16 ...
  int bits = 0;           ///< of one channel as stored (10 and 12 where the file says so)
  bool isFloat = false;
  int parts = 1;
  std::map<std::string, std::string> text;  ///< text attributes of the header
};

struct ImageFile {
  Image image;  ///< pixels as stored: no colour conversion; integer types scaled to 0..1
  ImageFileInfo info;
};

/// Reads a picture with all its channels. Parts of a multi-part EXR become layers (part name + dot +
/// channel). EXR, PNG, TIFF, JPEG, Radiance HDR, camera raw (developed to linear camera RGB: no gamma, no
/// automatic brightening, highlights not clipped, no white balance). Throws InputError that names the file.
[[nodiscard]] ImageFile readImage(const std::filesystem::path& file);
/// Header only: channel names and size.
[[nodiscard]] ImageSpec readImageSpec(const std::filesystem::path& file, ImageFileInfo* info = nullptr);

struct WriteOptions {
  std::string pixelType;  ///< half | float | uint8 | uint16; empty: half for EXR, float for HDR, uint8 for
                          ///< JPEG and PNG, uint16 for TIFF
  std::vector<std::string> channelTypes;    ///< EXR: a type a channel, instead of pixelType
  std::string compression;                  ///< empty: the format's own (EXR: zip)
  std::map<std::string, std::string> text;  ///< attributes to put into the header
  int jpegQuality = 95;
};

/// Writes to a temporary name beside the file, then renames. The format follows the extension. Pixels are
/// written as they are: no colour conversion. Throws InputError where it cannot be written.
void writeImage(const Image& image, const std::filesystem::path& file, const WriteOptions& options = {});

}  // namespace swaplight
