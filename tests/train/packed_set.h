#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace training {

/// A rendered set as train_umbra.py reads it: int32 the number of lamps, then for each lamp four uint8
/// planes, R G B (16 steps a stop; 255 is 2 stops above the lamp's 99th percentile, 0 is nothing) and
/// visibility (255 all of the lamp, 0 none, or it faces away). A lamp that lights less than 2 % of the
/// picture is left out.
///
/// `light`, `seen`: what tracePixel() gives, a pixel after the other.
[[nodiscard]] std::vector<uint8_t> packedSet(int lampCount, size_t pixels, const float* light,
                                             const float* seen);

}  // namespace training
