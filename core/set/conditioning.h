#pragma once

#include <array>
#include <string>
#include <vector>

namespace swaplight {

/// How well the lights' colours, shot by shot, tell the lights apart.
struct Conditioning {
  /// Singular values of each channel's matrix, largest first. For N rotated colours they are the magnitudes
  /// of the DFT of the colours.
  std::array<std::vector<double>, 3> singularValues;
  /// largest / smallest; infinity where the channel cannot tell the lights apart.
  std::array<double, 3> condition{};
  /// Standard error of a contribution over that of a shot, solved channel by channel: RMS over the lights of
  /// the rows of the pseudo-inverse. Infinite in a singular channel.
  std::array<double, 3> amplification{};
  /// The same for the matte model, which pools the channels, on a neutral surface. Infinite where some
  /// mixture of lights is seen by no channel of any shot.
  double matteAmplification = 0;
  std::vector<std::string> advice;  ///< what is degenerate and what to do, in words
};

}  // namespace swaplight
