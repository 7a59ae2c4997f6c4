#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/capture/capture.h"
#include "core/image/image.h"
#include "core/image/io/carried_data.h"
#include "core/set/solve_report.h"

namespace swaplight {

/// Bits of quality.flags (docs/formats.md, A solved set).
enum PixelFlag : uint8_t {
  kClipped = 1,    ///< clipped in a shot
  kTooDark = 2,    ///< too dark to tell
  kMoved = 4,      ///< moved between shots
  kNotFinite = 8,  ///< not finite, or negative beyond noise, in a shot
  kFilled = 16,    ///< filled in from neighbours
};

/// The channels of SolvedSet::quality, in order.
enum QualityChannel { kResidual = 0, kSigma = 1, kFlags = 2, kModel = 3 };

/// A capture whose lights have been told apart. Pictures are linear light in the primaries that their spec
/// names, all the same ones; the lights at unit white.
struct SolvedSet {
  Capture capture;
  std::vector<Image> contributions;  ///< T[i], one a light in the capture's order; R G B, >= 0, finite
  /// What of each contribution is highlight: R G B, one a light, 0 .. T[i]. Empty: none is known.
  std::vector<Image> highlights;
  Image beta;  ///< a channel a light, 0..1; a pixel's sum is 1, or 0 where no light reaches it (updateBeta)
  std::optional<Image> ambient;  ///< R G B, finite; what no controlled light explains
  Image quality;  ///< residual, sigma, flags (a bit field stored as float), model (0: the matte model was
                  ///< enough, 1: the full contribution was needed)
  std::shared_ptr<const CarriedData> carried;  ///< what the photographs' files hold beside their colour
  std::optional<SolveReport> report;           ///< how it was solved; nothing: the file did not say

  [[nodiscard]] int lightCount() const { return static_cast<int>(contributions.size()); }
  [[nodiscard]] int width() const { return contributions.front().width(); }
  [[nodiscard]] int height() const { return contributions.front().height(); }
  [[nodiscard]] const std::string& colorSpace() const { return contributions.front().spec().colorSpace; }
};

/// Sets each highlight to what of it lies within 0 and its light's contribution.
void keepHighlightsInLights(SolvedSet& set);

/// The set under every light at unit white: sum of T, and ambient.
[[nodiscard]] Image sumAtUnitWhite(const SolvedSet& set);

/// beta of neighbouring pixels: the sum over channels of each light's contribution (three planes a light)
/// over that of all lights; 0 where there is none.
void sharesOf(int lights, const float* const* contributions, float* const* shares, size_t count);

/// beta[i] = sum over channels of T[i] / sum over lights and channels; written into set.beta.
void updateBeta(SolvedSet& set);

}  // namespace swaplight
