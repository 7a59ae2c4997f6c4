#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// A camera's measured response, code by code: the light that makes a code, in each channel. A capture's
/// "color_space" names its file: "camera.csv", relative to the capture.
struct ResponseCurve {
  /// [channel][k]: the light of code k / (count - 1), rising, the same count in all. 1 is full scale.
  std::array<std::vector<float>, 3> light;

  /// Between the codes linear; 0 below the first code, past the last one as steep as the curve's end.
  [[nodiscard]] float at(int channel, float code) const;
  /// Codes R G B become light.
  void apply(const ImageSpan& pixels) const;
};

/// Whether a colour space's name is that of a response's file.
[[nodiscard]] bool isResponseFile(const std::string& colorSpace);

/// Throws InputError that begins with `where` where a response's file is meant to be and its name does not
/// end in .csv.
void checkResponseFile(const std::string& name, const std::string& where);

/// Reads lines "code,red,green,blue" or "code,light": codes 0..1, rising, and their light; # begins a
/// comment, a first line of names is skipped. Throws InputError that says file and line.
[[nodiscard]] ResponseCurve readResponse(const std::filesystem::path& file);
void writeResponse(const ResponseCurve& curve, const std::filesystem::path& file);

}  // namespace swaplight
