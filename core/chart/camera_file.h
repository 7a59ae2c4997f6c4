#pragma once

#include <filesystem>
#include <string>

#include "core/base/json_fwd.h"
#include "core/chart/chart_fit.h"
#include "core/image/image.h"

namespace swaplight {

struct ChartShot;

/// A camera's matrix as a file tells it (docs/formats.md, "A camera").
struct CameraFile {
  CameraMatrix matrix{};
  std::string from;  ///< linear primaries of what it is for

  /// A picture in linear light in which `white` (of those primaries, no channel 0) is white: in place to
  /// linear Rec.709, in which `to` is.
  void apply(Image& picture, const Rgb& white, const Rgb& to) const;
};

/// As a file that readCamera reads. `shot` has a matrix.
[[nodiscard]] Json jsonFromCamera(const ChartShot& shot);

/// Throws InputError that says what is wrong: no such description, a version to come, a matrix that keeps no
/// white, primaries that are not known.
[[nodiscard]] CameraFile cameraFromJson(const Json& json);
/// The same of a file, which errors name; also where it is missing or no JSON.
[[nodiscard]] CameraFile readCamera(const std::filesystem::path& file);

}  // namespace swaplight
