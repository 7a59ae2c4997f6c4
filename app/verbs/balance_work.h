#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/balance/white_point.h"
#include "core/base/json.h"
#include "core/base/progress.h"
#include "core/chart/camera_file.h"
#include "core/color/rgb.h"
#include "core/image/image.h"
#include "core/image/io/carried_data.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// A photograph that is being balanced.
struct BalanceWork {
  std::shared_ptr<const ColorConfig> config;
  std::string photograph;
  Image picture;
  std::shared_ptr<const CarriedData> carried;  ///< what else the photograph's file holds
  float clip = 0;                              ///< at and above which the sensor was saturated
  Rgb white{1, 1, 1};                          ///< in the picture's primaries, luminance 1
  Rgb weights{0, 0, 0};                        ///< of the primaries' luminance
  Json json;                                   ///< what is said of it
  std::vector<std::string> warnings;

  /// Once the picture, and with it its primaries, is known.
  void setWhite(const WhitePoint& point);
};

[[nodiscard]] Json jsonFromRgb(const Rgb& color);

/// What takes off the cast that is left, last of all: a grey card at "X,Y" or "X,Y,SIDE". Throws InputError.
void balanceByCard(BalanceWork& work, const std::string& place);

/// The same by the greys of a Macbeth chart that is found in the picture; the camera's colours become
/// Rec.709's by its patches, where they tell. Throws InputError where there is no chart.
void balanceByChart(BalanceWork& work, const WhitePoint& white, const Progress& progress);

/// A camera's matrix divides by the white: it must have something of every channel. Throws InputError.
void checkWhiteFor(const CameraFile& camera, const ColorConfig& config, const WhitePoint& white);

/// The camera's colours become those of Rec.709. `file`: where the matrix is from. Throws InputError where
/// the photograph has other primaries.
void correctCamera(BalanceWork& work, const CameraFile& camera, const std::string& file,
                   const WhitePoint& white);

}  // namespace swaplight
