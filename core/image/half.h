#pragma once

#include <cstddef>
#include <cstdint>

namespace swaplight {

/// IEEE half floats as their 16 bits. Round to nearest even; too large becomes infinity, NaN stays NaN.
void halfFromFloat(const float* in, uint16_t* out, size_t count);
void floatFromHalf(const uint16_t* in, float* out, size_t count);

}  // namespace swaplight
