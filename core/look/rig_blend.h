#pragma once

#include "core/relight/rig.h"

namespace swaplight {

/// The rig between two: at 0 the one, at 1 the other, as they are. Between them every light's factor, with
/// its group, solo and mute, goes in a straight line from one to the other, so that the frame is
/// (1 - amount) A + amount B in scene-linear light: a dissolve, made by dimmers. Names, roles and groups are
/// those of `from`; lights that `to` does not have stay. amount: 0..1.
[[nodiscard]] Rig blendRigs(const Rig& from, const Rig& to, float amount);

}  // namespace swaplight
