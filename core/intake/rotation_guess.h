#pragma once

#include <string>
#include <vector>

#include "core/intake/capture_draft.h"

namespace swaplight {

/// Which light had which colour in every shot, as the pictures tell.
struct RotationGuess {
  std::vector<int> steps;  ///< of each lighting: light i has colour (i + step) of the ring; the first is 0
  double misfit = 0;       ///< RMS, relative to the signal: what the matte model leaves under this plan
  double nextMisfit = 0;   ///< of the second best plan; 0 where there was no other
  size_t tried = 0;        ///< plans
  std::string words;       ///< how it was found, and how sure it is
};

/// Guesses how a ring of as many colours as lights went round. In the first shot light i has colour i: which
/// of the lamps is called what cannot be seen in pictures. Every plan in which no two shots are alike (with
/// more shots than lights: every plan) is held against the pictures: the one that matte surfaces explain best
/// is taken. Beyond kMostPlans only steady rotations are tried. Throws InputError: a colour is unknown, not
/// one colour a light.
[[nodiscard]] RotationGuess guessRotation(const CaptureDraft& draft, const CapturePixels& pixels,
                                          const std::vector<ShotColor>& ring);
inline constexpr size_t kMostPlans = 64;

/// The draft with the ring's colours in every lighting.
[[nodiscard]] CaptureDraft withRotation(CaptureDraft draft, const std::vector<ShotColor>& ring,
                                        const std::vector<int>& steps);

}  // namespace swaplight
