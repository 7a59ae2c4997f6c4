#pragma once

namespace swaplight {

/// A row of a light's contribution, R G B apart.
struct SurfaceRow {
  float* channel[3];
};

/// What a light gives to surfaces of another colour: T' = T rho' / rho, channel by channel. `before` and
/// `after`: the set at unit white, which is rho and rho' up to the light. Where a surface hardly reflects a
/// channel, T / rho is noise: the more so, the more the light's share of the other channels counts instead;
/// and so it is where the whole set gives no more than `dark`. inverseGrey: 1 / (r + g + b) of `before`, 0
/// where it is dark. Where both are equal, T stays to the bit.
void changeReflectanceRow(const float* const before[3], const float* const after[3], const float* inverseGrey,
                          float dark, int count, const SurfaceRow& light);

}  // namespace swaplight
