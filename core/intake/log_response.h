#pragma once

#include <vector>

#include "core/intake/response_samples.h"

namespace swaplight {

// A channel's response g(z) = ln of the light of code z, z of 0..255, up to one constant; it does not fall.

/// Debevec and Malik 1997, equation 3, with each pixel's light eliminated, so that thousands of pixels count:
/// min sum w^2 (g(z) - ln E - ln t)^2 + lambda sum (w h'')^2, where w is their hat, z or 255 - z, and h what
/// g differs by from a gamma of 2.2. Codes that nothing shows are continued smoothly.
[[nodiscard]] std::vector<double> debevecResponse(const ResponseSamples& samples);

/// Robertson, Borman and Stevenson 2003: min sum w (f(z) - t x)^2 over the response f itself, w a Gauss, so
/// that bright codes count most. Their iteration ends where this does at once: with each pixel's light x put
/// in, it is a quadratic form in f. f is smooth by a gamma of 2.2, as above, which continues what is not
/// seen.
[[nodiscard]] std::vector<double> robertsonResponse(const ResponseSamples& samples);

/// That of a gamma of 2.2, from which both are smooth.
[[nodiscard]] double usualLogResponse(int level);

/// How much a sample of that code says: w^2 of Debevec and Malik, 0..1.
[[nodiscard]] double responseWeight(int level);

}  // namespace swaplight
