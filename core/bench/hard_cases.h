#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/solve/model/noise_model.h"
#include "core/solve/model/solve_options.h"

namespace swaplight {

/// A capture that is hard to solve, photographed with noise of a fixed seed, and its truth.
struct HardCase {
  std::string name;
  std::string group;   ///< what makes it hard, in a word
  bool matte = false;  ///< only noise stands between the matte model and the pictures
  bool mixed = false;  ///< matte and glossy surfaces in one picture
  Capture capture;     ///< what the solver is told
  CapturePixels pixels;
  std::vector<Image> truth;  ///< contributions, one a light; nothing in a channel that no light has
  NoiseModel noise;          ///< what the noise is, for the bound
  SolveOptions options;
};

/// The names of all cases, and one of them by its place among them, `width` pixels wide and two thirds as
/// high. A small still life under two lights with swapped colours .9/.2/.15 and .15/.8/.25, full well 20000
/// and read noise .002, exposed so that 0.5 % of the pixels are beyond .9 of full scale, but for what the
/// case is about.
[[nodiscard]] std::vector<std::string> hardCaseNames();
[[nodiscard]] HardCase makeHardCase(int index, unsigned seed, int width = 192);

/// The same still life without a difficulty, under as many lights that change places; `gloss` as in
/// BenchPicture.
[[nodiscard]] HardCase makeStillLife(int lights, float gloss, unsigned seed, int width);

/// A capture with truth, photographed again: its own colours, its noise or the usual. Throws InputError where
/// it has no truth.
[[nodiscard]] HardCase hardCaseOfCapture(Capture capture, unsigned seed);

}  // namespace swaplight
