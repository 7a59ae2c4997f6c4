#pragma once

#include <array>

namespace swaplight {

/// A colourist's wheel: grey in the middle; towards a hue of the rim (red at the right, then clockwise, as
/// the disc of a light's colour) its channel gets more and the others less. `values` are the three channels,
/// whose mean stays; at the rim the channel that it points to is `reach` away from the mean. Shift drags ten
/// times finer, a double-click takes the balance out. True in frames in which it changes.
bool balanceWheel(const char* id, std::array<double, 3>& values, double reach, float side);

}  // namespace swaplight
