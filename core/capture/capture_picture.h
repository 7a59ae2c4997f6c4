#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/capture/capture.h"
#include "core/capture/jpeg/jpeg_error.h"
#include "core/capture/response_curve.h"
#include "core/capture/sensor_limits.h"
#include "core/image/image.h"
#include "core/image/io/carried_data.h"
#include "core/image/io/image_io.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// A picture of a capture, as read: cropped, in linear light.
struct CapturePicture {
  std::filesystem::path file;
  Image image;
  ImageFileInfo info;
  PixelRect window;  ///< of the image: what the file holds of it
  bool hasOverscan = false;
  PixelCounts counts;
  float clip = std::numeric_limits<float>::infinity();  ///< of integer files
  float quantum = 0;
  std::vector<ValueVariance> rounding;     ///< of codes that are not proportional to light
  std::vector<ValueVariance> codingError;  ///< linear light
  std::shared_ptr<CarriedData> carried;
  std::vector<std::string> inexact;  ///< channels
  std::vector<std::string> warnings;
};

/// Reads one of a capture's pictures and brings it to linear light (linearSpaceOf), by `response` where the
/// capture has a measured one. Full size: it is not scaled. Throws InputError that names the file.
[[nodiscard]] CapturePicture readCapturePicture(const ColorConfig& config, const Capture& capture,
                                                const ResponseCurve* response, const std::string& path);

}  // namespace swaplight
