#pragma once

#include <vector>

#include "core/solve/estimators/matte_fit.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// What the matte model leaves of a block of 8 x 8 neighbouring pixels, sorted by how it varies over the
/// block. Texture, shading and relief are not in it: the model follows them.
struct BlockMisfit {
  float brightness = 0;  ///< mean of the shots
  float freedom = 0;     ///< of a pixel's residuals; lights that are held at zero count
  /// Variance over what the noise model expects, of second differences (y00 - y10 - y01 + y11) / 2 of pixels,
  /// and of 2 x 2 means: noise is the same in both, unless it is correlated (JPEG, demosaicing).
  float fine = 0, coarse = 0;
  /// Squared mean over the block, relative to the mean squared signal, less what noise leaves there: what is
  /// wrong with the model itself, colours above all.
  float smooth = 0;

  static constexpr int kPixels = 64;
  static constexpr int kFineDegrees = 16;  ///< independent differences a block, times its freedom
  static constexpr int kCoarseDegrees = 4;
};

/// Of about `count` blocks, spread evenly over the set; those with flagged pixels are left out. `matte` fits
/// by `noise`, which is also what `fine` and `coarse` are measured by.
[[nodiscard]] std::vector<BlockMisfit> blockMisfits(const MatteFit& matte, const LightingMatrix& lighting,
                                                    const NoiseModel& noise, const ShotSignal& signal,
                                                    int count);

/// The mean of every shot and channel over a block.
struct BlockMean {
  size_t place;               ///< of its first pixel in the picture
  std::vector<float> values;  ///< [3 shot + channel]
};
/// Of the same blocks.
[[nodiscard]] std::vector<BlockMean> blockMeans(const ShotSignal& signal, int shots, int count);

}  // namespace swaplight
