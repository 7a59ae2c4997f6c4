#pragma once

#include <string>
#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/intake/shot_folder.h"

namespace swaplight {

/// Photographs of one lighting at several exposures, one after the other: a bracket. All of a capture's are
/// of one length. A solve takes every exposure as a shot of its own, each with its own noise and clipping.
struct Brackets {
  int length = 1;            ///< exposures of each lighting; 1: there are no brackets
  std::vector<float> stops;  ///< of each shot, over the first one; empty: as the files say
  std::string words;         ///< how they were found, or ""

  /// Which lighting a shot is of: 0, 1 ...
  [[nodiscard]] size_t lightingOf(size_t shot) const { return shot / static_cast<size_t>(length); }
};

/// By exposures that are told, in stops: those of one bracket, which all others repeat ("0,-3,+2"), or one a
/// photograph; "0" says that all are alike. Throws InputError: no numbers, or the photographs are no multiple
/// of them.
[[nodiscard]] Brackets toldBrackets(const ShotFolder& folder, const std::string& exposures);

/// The longest series of different exposures that repeats itself: by what the files state, where all of them
/// do and the pictures of a bracket are one lighting's; else by the pictures. Exposures are measured in the
/// pictures, where those are linear: a camera's 1/60 s is 1/64 s. No brackets where exposures are alike:
/// those are of different lightings.
[[nodiscard]] Brackets findBrackets(const ShotFolder& folder, const CapturePixels& pixels);

/// By what the files state alone; also of one lighting. Throws InputError where a file does not say its
/// exposure or they are no brackets.
[[nodiscard]] Brackets statedBrackets(const ShotFolder& folder);

/// Where the pictures contradict exposures that were told, or are not proportional to them.
[[nodiscard]] std::vector<std::string> bracketWarnings(const ShotFolder& folder, const CapturePixels& pixels,
                                                       const Brackets& brackets);

/// "0, -3, +2"
[[nodiscard]] std::string exposureList(const Brackets& brackets);

}  // namespace swaplight
