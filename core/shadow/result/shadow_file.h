#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/set/solved_set.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// One light's shadows under its name.
struct NamedShadows {
  std::string light;
  const LightShadows* shadows = nullptr;
};

/// Writes an EXR with the channels shadow_<light>.Y (visibility 0..1, half) and shadow_<light>.label (0
/// unknown, 1 umbra, 2 penumbra, 3 lit, half), in the set's window and pixel aspect. Throws InputError where
/// it cannot be written.
void writeShadows(const SolvedSet& set, const std::vector<NamedShadows>& lights,
                  const std::filesystem::path& file);

/// Throws what writeShadows() would for a file that is no EXR, before the search.
void checkShadowFile(const std::filesystem::path& file);

/// The set under all its lights, dimmed, with the outline of each light's umbra and, thinner, of its
/// penumbra with ticks on the shadow's side, in a colour a light, and their names; hatched in that colour,
/// where it cannot be told. R G B, sRGB code values.
[[nodiscard]] Image drawShadowOutlines(const SolvedSet& set, const std::vector<NamedShadows>& lights);

}  // namespace swaplight
