#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/intake/shot_folder.h"

namespace swaplight {

/// What a capture tells of a photograph of its folder.
struct ToldPhotograph {
  bool used = true;
  /// One a light of the capture, as shotColorFromText reads them; "" is not told. Empty: the capture knows
  /// nothing of the photograph.
  std::vector<std::string> colors;
};

/// For each photograph of the folder, by its file's name.
[[nodiscard]] std::vector<ToldPhotograph> toldPhotographs(const Capture& capture, const ShotFolder& folder);

/// The exposures of a folder's photographs as a capture has them, in stops; 0 for what it does not know.
[[nodiscard]] std::vector<float> toldExposures(const Capture& capture, const ShotFolder& folder);

/// The pictures of some of the shots, by their places, in that order. They are copied, but where it is all.
[[nodiscard]] std::shared_ptr<const CapturePixels> pixelsOf(std::shared_ptr<const CapturePixels> pixels,
                                                            const std::vector<size_t>& shots);

}  // namespace swaplight
