#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "core/image/io/carried_data.h"

namespace swaplight {

/// A time code as an EXR header packs it (ImfTimeCode.h, TV60, whatever the rate; SMPTE 12M): hours, minutes,
/// seconds and frame (0..29) in binary coded decimals, and flags.
using PackedTime = uint32_t;

/// Whether time codes can count so many frames a second: 1..30, and even ones up to 60.
[[nodiscard]] bool countsFrames(int fps);

/// The time code `frames` frames later (or earlier); goes round at midnight, keeps the flags. `fps`: frames
/// in a second, of which countsFrames() is true. Above 30 pairs of frames are counted, as there is no room
/// for more, and the field flag is set in the second frame of a pair (SMPTE 12M-1, 50 and 60 frames). Where
/// the drop-frame flag is set, the first two frames (or pairs) of a minute are not counted, but of every
/// tenth.
[[nodiscard]] PackedTime advanced(PackedTime time, int frames, int fps);

/// What is carried with its time code that many frames later; the same where there is no time code, or no
/// frames. The rate is that of the header (FramesPerSecond, rounded), 24 where it says none; at a rate that
/// time codes cannot count the later frames have none.
[[nodiscard]] std::shared_ptr<const CarriedData> withTimecode(
    const std::shared_ptr<const CarriedData>& carried, int frames);

}  // namespace swaplight
