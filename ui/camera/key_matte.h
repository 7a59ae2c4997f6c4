#pragma once

#include <optional>
#include <vector>

#include "core/color/rgb.h"
#include "core/edit/mask/mask.h"
#include "core/filter/filter_library.h"
#include "core/relight/rig.h"

namespace swaplight {

/// The matte of a key filter (chroma-key, luma-key, or one that a person made of them) as the part of a
/// selection: of the frame under these lights, in sRGB, before other filters. Nothing where the filter is no
/// key. `factors`: the rig's, as rigFactors gives them.
[[nodiscard]] std::optional<MaskShape> keyMatteOf(const ResolvedStage& stage, const Rig& rig,
                                                  const std::vector<Rgb>& factors);

}  // namespace swaplight
