#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/ocio/color_config.h"
#include "core/relight/rig.h"
#include "core/set/solved_set.h"

namespace swaplight {

// What a mixer does to lights as a whole. Names, roles and groups stay as they are.

/// Every light as in a shot of the capture: its colour and exposure. Lights whose colour is unknown there
/// stay as they are.
[[nodiscard]] Rig rigOfShot(const ColorConfig& config, Rig rig, const SolvedSet& set, size_t shot);
/// Every light on, at unit white, without stops; groups and ambient neutral.
[[nodiscard]] Rig unitWhiteRig(Rig rig);
[[nodiscard]] Rig allOffRig(Rig rig);

/// One light as it was in the beginning.
[[nodiscard]] LightSetting resetLight(const LightSetting& setting);
/// The part of a light that is copied from one to another: colour, stops, multiplier, on.
[[nodiscard]] LightSetting pastedLight(const LightSetting& onto, const LightSetting& copied);

/// Adds stops to lights; where one of them is locked (ratioLock), to all locked ones.
[[nodiscard]] Rig addStops(Rig rig, std::span<const size_t> lights, float stops);

/// What each light gives to one pixel of a set, under unit white, in the set's primaries.
struct PixelShares {
  std::vector<Rgb> lights;
  Rgb ambient{0, 0, 0};
  /// A light that the set lacks, because it was made a moment ago, gives nothing.
  [[nodiscard]] Rgb of(size_t light) const { return light < lights.size() ? lights[light] : Rgb(0); }
};
[[nodiscard]] PixelShares pixelShares(const SolvedSet& set, int x, int y);
/// What each light gives to the pixel under a rig, in the order of the lights; ambient last. Their sum is the
/// relit pixel.
[[nodiscard]] std::vector<Rgb> relitShares(const ColorConfig& config, const Rig& rig,
                                           const PixelShares& shares, const std::string& colorSpace);

/// The hue and saturation of a pixel as a light's colour at full brightness; white for black.
[[nodiscard]] LightColor lightColorOfPixel(const ColorConfig& config, const Rgb& pixel,
                                           const std::string& colorSpace);

/// The rig in which the chosen lights, recoloured together, make a pixel neutral (R = G = B in the set's
/// primaries) at the mean of its channels. Every chosen light's colour is multiplied by the same gain a
/// channel, kept within 1/16 .. 16; the other lights stay. Nothing where the chosen lights do not reach the
/// pixel.
///
///   gain_c = (mean - others_c) / chosen_c
[[nodiscard]] std::optional<Rig> neutralizePixel(const ColorConfig& config, Rig rig,
                                                 const PixelShares& shares, std::span<const size_t> chosen,
                                                 const std::string& colorSpace);

}  // namespace swaplight
