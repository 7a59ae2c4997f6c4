#pragma once

#include "core/capture/capture_pixels.h"

namespace swaplight {

/// A set of random pixels (albedo .05 .. .9, shading 0 .. .5 a light) and its photographs: the colours
/// of docs/formats.md's sample, rotated; full well 20000, read noise .002.
struct BenchScene {
  Capture capture;
  CapturePixels pixels;
};

/// `highlights`: the share of pixels that have a white highlight (mean .2) of a light. The same every time.
[[nodiscard]] BenchScene makeBenchScene(int width, int height, int lights, float highlights);

/// The same without highlights and without noise, every light reaching every pixel: a demultiplex of it gives
/// nothing negative.
[[nodiscard]] BenchScene makeLitScene(int width, int height, int lights);

/// Random pixels alone: the contributions of each light at unit white.
[[nodiscard]] std::vector<Image> randomTruth(int width, int height, int lights, float highlights);

/// Lights whose colours go round, by one light a shot. Without colours: those of docs/formats.md's sample.
[[nodiscard]] Capture makeBenchCapture(int lights, const std::vector<Rgb>& colors = {});

/// Photographs known contributions under a capture's colours with the noise that the capture states.
[[nodiscard]] CapturePixels photograph(const Capture& capture, const std::vector<Image>& truth,
                                       unsigned seed);

}  // namespace swaplight
