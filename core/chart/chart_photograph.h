#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/chart/chart_shot.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// A photograph that is decoded once and asked for its chart as often as a person moves the corners.
struct ChartPhotograph {
  std::filesystem::path file;
  CapturePixels pixels;  ///< one shot, linear
  /// log2 of exposure time x ISO / f-number squared; nothing where the file does not say all three.
  std::optional<double> exposureStops;

  [[nodiscard]] const Image& picture() const { return pixels.shots.front(); }
  [[nodiscard]] float clipLevel() const { return pixels.clipLevel.front(); }
};

/// `colorSpace`: of the file; empty: see colorSpaceOfPhotograph. Throws InputError that names the file,
/// Stopped.
[[nodiscard]] ChartPhotograph readChartPhotograph(const ColorConfig& config,
                                                  const std::filesystem::path& file,
                                                  const std::string& colorSpace,
                                                  const Progress& progress = {});

/// What its chart says, where one is found (see findChart); nothing where none is. Throws InputError where
/// too much of it is saturated or black; Stopped.
[[nodiscard]] std::optional<ChartShot> foundChart(const ChartPhotograph& photograph,
                                                  const Progress& progress = {});

/// The same where a person says that it lies: the corners in any order around it, a fifth of a patch off at
/// most, from where they are moved to where the patches are even. Throws InputError as orientedCorners and
/// fitChart do.
[[nodiscard]] ChartShot chartAt(const ChartPhotograph& photograph, const ChartCorners& corners);

/// The same where it lies in another photograph by a camera that stood still, with a warning that says so;
/// nothing where no chart can be there, or the photographs differ in size. For charts under gels so deep that
/// they are not found.
[[nodiscard]] std::optional<ChartShot> chartAsIn(const ChartPhotograph& photograph, const ChartShot& other);

}  // namespace swaplight
