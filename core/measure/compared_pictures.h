#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/measure/difference.h"

namespace swaplight {

/// Two pictures out of files, brought to one encoding and exposure.
struct ComparedPictures {
  PicturePair pair;
  /// True where channels are compared as the numbers that they are (beta, depth, a light's layer): unscaled,
  /// and de2000 does not apply. False where they are R G B.
  bool numbers = false;
  std::vector<std::string> warnings;  ///< of a file's colours that are not known
};

/// Reads what can be compared of two files: the channels that are asked for, each by the name that both have
/// ("beta.*": all of beta, as a shell would choose); else R G B (one channel counts as all three where it is
/// grey: of an integer file, or called Y, L, I, R); else every channel that both have. Of R G B,
/// floating-point files (EXR, HDR) are taken as linear Rec.709, integer files (PNG, TIFF, JPEG) as sRGB; one
/// of each is compared as linear light. `scale` is the exposure of linear pictures, above 0; nothing: so that
/// the reference's 99.5th percentile is .9. Throws InputError: unreadable file, pictures of different size,
/// no channel of both, bad scale. What lies outside of both data windows is no number.
[[nodiscard]] ComparedPictures readCompared(const std::filesystem::path& test,
                                            const std::filesystem::path& reference,
                                            const std::vector<std::string>& channels,
                                            std::optional<float> scale);

}  // namespace swaplight
