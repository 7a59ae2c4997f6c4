#pragma once

#include <span>

namespace swaplight {

/// Poisson's equation on a picture with free borders: finds the `solution`, of mean zero, in which the sum of
/// (a pixel - its neighbour) over its two to four neighbours is what is `wanted` there, which has to sum to
/// zero. Rows from the top, width x height of both. The residual left is less than a thousandth of what was
/// wanted, RMS. The error is a few thousandths of a picture with shading in it; of nothing but noise a
/// hundredth, of strips a few pixels wide more.
///
/// Full multigrid (Brandt, "Multi-level adaptive solutions to boundary-value problems", Math. Comp. 31, 1977;
/// with cells that are halved, Trottenberg et al., "Multigrid", 2001, section 2.8): the solution of the
/// picture at half its size, brought to its own, and two cycles, each of which leaves a tenth of the error.
/// A cycle takes the picture through the caches once. Works on all threads; the bytes do not depend on how
/// many.
void solvePoisson(int width, int height, std::span<const float> wanted, std::span<float> solution);

}  // namespace swaplight
