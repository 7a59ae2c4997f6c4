#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/capture/capture.h"
#include "core/capture/jpeg/jpeg_error.h"
#include "core/image/image.h"
#include "core/image/io/carried_data.h"

namespace swaplight {

/// A capture's pictures: linear light, R G B, all of one size. 1.0 is full scale of the sensor. Values are as
/// the sensor gave them: exposure differences and ambient light are still in, because noise and clipping are
/// properties of the raw signal; the dark picture is subtracted, except from saturated values. Pixels that
/// are NaN, infinite or negative stay so.
struct CapturePixels {
  std::vector<Image> shots;
  std::optional<Image>
      ambient;  ///< at exposure_stops 0; 0 where the file's is no number, where no shot is one
  /// A shot's value at and above which the sensor was saturated; infinity where nothing clips. For integer
  /// files just below their largest value; for floating point see floatClipLevel.
  std::vector<float> clipLevel;
  /// The step of the files' coding in linear light at full scale: 1/255 for 8 bits of linear light, 2.3/255
  /// for 8 bits of sRGB; 10, 12 and 14 bits in 16-bit files are recognised. 0 for floating point.
  std::vector<float> quantum;
  /// Where codes are not proportional to light (sRGB, a gamma, a camera log): roundingErrors. Empty: the step
  /// is the same everywhere.
  std::vector<ValueVariance> rounding = {};
  /// What the JPEG coding of all shots has left: the variance of linear light around it (jpeg_error.h). Empty
  /// for other files, and for such that were JPEGs once.
  std::vector<ValueVariance> codingError = {};
  /// What the first shot's file holds beside its colour; may be nothing. Its data window is what all pictures
  /// show.
  std::shared_ptr<const CarriedData> carried;
  std::vector<std::string> warnings;  ///< such as pixels that are not finite, with their number
  /// Of each shot, what its saturated values are multiplied by, so that they lie above clipLevel. Empty: 1.
  std::vector<float> clippedLift = {};

  [[nodiscard]] int width() const { return shots.empty() ? 0 : shots.front().width(); }
  [[nodiscard]] int height() const { return shots.empty() ? 0 : shots.front().height(); }
  /// The light that a value of a shot shows, at least where it is saturated.
  [[nodiscard]] float shown(size_t shot, float value) const {
    return clippedLift.empty() || value < clipLevel[shot] ? value : value / clippedLift[shot];
  }
  /// What all pictures show, where that is not all of them: the rest is 0 in some, and is no light.
  [[nodiscard]] std::optional<PixelRect> dataWindow() const {
    return carried ? carried->dataWindow : std::nullopt;
  }
};

/// The variance of light that rounding to codes makes, over that of the last `step` below white (a step is
/// 1/255 for 8 bits), around codes from black to white. `light` of a code 0..1: not less for a larger one.
/// Nothing where the last step makes no difference.
[[nodiscard]] std::vector<ValueVariance> roundingErrors(const std::function<float(float)>& light, float step);

/// All that is known of the shots, without them.
[[nodiscard]] CapturePixels withoutShots(const CapturePixels& pixels);

/// The primaries that a capture's pictures have in linear light, and its light colours, by its colour space:
/// lin_rec709, acescg and aces2065_1 stay, anything else becomes lin_rec709.
[[nodiscard]] std::string linearSpaceOf(const std::string& colorSpace);

/// Reads the pictures and brings them to linear light: see linearSpaceOf. Throws InputError: missing or
/// broken file, sizes that differ (both named with their sizes), one photograph under two files' names and
/// other colours, an ambient or dark picture without a number, data windows with nothing in common, unknown
/// colour space (the known ones listed).
[[nodiscard]] CapturePixels loadCapturePixels(const ColorConfig& config, const Capture& capture,
                                              const Progress& progress = {});

}  // namespace swaplight
