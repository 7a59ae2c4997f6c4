#include "core/color/chromaticities.h"

#include <cmath>

namespace swaplight {
namespace {

struct Primaries {
  const char* colorSpace;
  Chromaticities xy;
};

// ITU-R BT.709-6; SMPTE ST 2065-1 (AP0); Academy S-2014-004 (AP1).
constexpr std::array<Primaries, 3> kKnown = {
    {{"lin_rec709", {0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F}},
     {"acescg", {0.713F, 0.293F, 0.165F, 0.830F, 0.128F, 0.044F, 0.32168F, 0.33767F}},
     {"aces2065_1", {0.7347F, 0.2653F, 0.0F, 1.0F, 0.0001F, -0.077F, 0.32168F, 0.33767F}}}};

// Those of which files are read but in which nothing is solved: ITU-R BT.2020-2; SMPTE EG 432-1.
constexpr std::array<Primaries, 2> kRead = {
    {{"lin_rec2020", {0.708F, 0.292F, 0.170F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.3290F}},
     {"lin_p3d65", {0.680F, 0.320F, 0.265F, 0.690F, 0.150F, 0.060F, 0.3127F, 0.3290F}}}};

bool near(const Chromaticities& a, const Chromaticities& b) {
  for (size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(a[i] - b[i]) < 1e-3F)) return false;
  return true;
}

}  // namespace

std::optional<Chromaticities> chromaticitiesOf(const std::string& colorSpace) {
  for (const Primaries& known : kKnown)
    if (known.colorSpace == colorSpace) return known.xy;
  return std::nullopt;
}

std::string colorSpaceOf(const Chromaticities& chromaticities) {
  for (const Primaries& known : kKnown)
    if (near(known.xy, chromaticities)) return known.colorSpace;
  for (const Primaries& known : kRead)
    if (near(known.xy, chromaticities)) return known.colorSpace;
  return {};
}

}  // namespace swaplight
