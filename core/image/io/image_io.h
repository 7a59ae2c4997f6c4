#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/color/chromaticities.h"
#include "core/image/header_values.h"
#include "core/image/image.h"
#include "core/image/pixel_pack.h"
#include "core/image/pixel_rect.h"

namespace swaplight {

/// What a file says beside its pixels.
struct ImageFileInfo {
  std::string format;     ///< openexr, png, tiff, jpeg, hdr, raw
  std::string pixelType;  ///< half, float, uint8, uint16 ...
  int bits = 0;           ///< of one channel as stored (10 and 12 where the file says so)
  bool isFloat = false;
  int parts = 1;
  std::map<std::string, std::string> text;  ///< text attributes of the header
  std::map<std::string, double> numbers;    ///< single numbers of the header, as ExposureTime
  /// What the header says of the colours: a colour space by name where it is a known one, else in words
  /// (`primaries .684 .313 ...`, `the profile "Adobe RGB (1998)"`); empty where it says nothing, or sRGB.
  std::string statedColors;
  HeaderValues header;                  ///< of all kinds, those that are about the picture, not the file
  float pixelAspect = 1;                ///< width over height of a pixel
  std::optional<PixelRect> dataWindow;  ///< EXR: where it leaves out something of the picture
  std::vector<PixelType> channelTypes;  ///< of every channel as stored
  bool operator==(const ImageFileInfo&) const = default;
};

struct ImageFile {
  Image image;  ///< pixels as stored: no colour conversion; integer types scaled to 0..1
  ImageFileInfo info;
};

/// Reads a picture with all its channels. EXR, PNG, TIFF, JPEG, Radiance HDR, camera raw (developed to linear
/// camera RGB: no gamma, no automatic brightening, highlights not clipped, no white balance). The image is
/// the display window: what a smaller data window leaves out is 0. Parts of a multi-part EXR become layers
/// (part name + dot + channel; a first part called rgb, rgba, main or beauty keeps its plain names). Alpha is
/// not multiplied in. The spec's colour space is what the file says or its format implies (lin_rec709,
/// acescg, aces2065_1, srgb, raw). Throws InputError that names the file: missing, not a picture, truncated,
/// empty, too large.
[[nodiscard]] ImageFile readImage(const std::filesystem::path& file);
/// Reads the channels straight to where they are wanted: `planes` is given the header and returns a plane a
/// channel (rows without gaps), or nullptr for those not wanted. Otherwise as readImage, but not turned
/// upright.
void readChannels(const std::filesystem::path& file,
                  const std::function<std::vector<float*>(const ImageSpec&, const ImageFileInfo&)>& planes,
                  const Progress& progress = {});
/// Header only: channel names and size.
[[nodiscard]] ImageSpec readImageSpec(const std::filesystem::path& file, ImageFileInfo* info = nullptr);

struct CarriedData;

struct WriteOptions {
  /// half | float | uint8 | uint16; empty: half for EXR, float for HDR, uint8 for JPEG and PNG, uint16 for
  /// TIFF. What a type cannot hold is clamped: half to +-65504, integers to 0..1 (NaN becomes 0 there).
  std::string pixelType;
  std::vector<std::string> channelTypes;    ///< EXR: half or float a channel, instead of pixelType
  std::string compression;                  ///< empty: the format's own (EXR, TIFF: zip)
  std::map<std::string, std::string> text;  ///< attributes to put into the header
  int jpegQuality = 95;
  std::shared_ptr<const CarriedData> carried;  ///< from the photographs, handed on
  std::optional<PixelRect> dataWindow = {};    ///< EXR: in place of the carried one
  std::vector<unsigned char> iccProfile = {};  ///< PNG, TIFF, JPEG: embedded
  std::optional<Chromaticities> chromaticities =
      {};  ///< EXR: where the colour space's name does not say them
};

/// Throws InputError, naming the file, where a WriteOptions::compression is none of OpenEXR's. A level may
/// follow a colon ("dwaa:45").
void checkExrCompression(const std::string& compression, const std::string& file);

/// Writes to a temporary name beside the file, then renames. The format follows the extension. Pixels are
/// written as they are: no colour conversion. An EXR is told the chromaticities of the image's colour space,
/// where they are known. Throws InputError where it cannot be written.
void writeImage(const Image& image, const std::filesystem::path& file, const WriteOptions& options = {});

}  // namespace swaplight
