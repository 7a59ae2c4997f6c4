#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "core/image/io/carried_data.h"

namespace swaplight {

/// A time code as an EXR header packs it (OpenEXR, TV60; SMPTE 12M): hours, minutes, seconds and frame in
/// binary coded decimals, and flags.
using PackedTime = uint32_t;

/// The time code `frames` frames later (or earlier); goes round at midnight, keeps the flags. `fps`: frames
/// counted in a second, 1..60. Where the drop-frame flag is set, the first two (at 60: four) frames of a
/// minute are not counted, but of every tenth.
[[nodiscard]] PackedTime advanced(PackedTime time, int frames, int fps);

/// What is carried with its time code that many frames later; the same where there is no time code, or no
/// frames. The rate is that of the header (FramesPerSecond, rounded), 24 where it says none.
[[nodiscard]] std::shared_ptr<const CarriedData> withTimecode(
    const std::shared_ptr<const CarriedData>& carried, int frames);

}  // namespace swaplight
