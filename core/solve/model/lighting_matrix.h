#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/capture/capture.h"
#include "core/color/rgb.h"
#include "core/set/conditioning.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// The colours that the lights had in each shot, exposure included: shot[k][c] = sum_i color(k,i)[c] T[i][c].
/// Everything about a capture's conditioning can be read off it, before a photograph is taken.
struct LightingMatrix {
  int shots = 0;
  int lights = 0;
  std::vector<std::string> names;  ///< of the lights, for messages
  std::vector<Rgb> colors;         ///< [shot * lights + light], linear, >= 0

  [[nodiscard]] const Rgb& color(int shot, int light) const {
    return colors[size_t(shot) * size_t(lights) + size_t(light)];
  }
  Rgb& color(int shot, int light) { return colors[size_t(shot) * size_t(lights) + size_t(light)]; }
  /// The shots x lights matrix of a channel.
  [[nodiscard]] Eigen::MatrixXd matrix(int channel) const;
};

/// The lighting of a capture. Unknown colours stand at the mean of the known ones that their lights have in
/// other shots, or at white: what has one name everywhere at the same.
[[nodiscard]] LightingMatrix lightingFromCapture(const Capture& capture);

/// How well the shots tell the lights apart.
[[nodiscard]] Conditioning conditioningOf(const LightingMatrix& lighting);

/// Throws InputError where no model can tell the lights apart: fewer shots x channels than the matte model
/// has unknowns, two lights with the same colour in every shot (both named), a light that is never on.
/// `unknown`: which unknown colour stands at shot * lights + light, -1: none. It is as no other.
void checkSolvable(const LightingMatrix& lighting, const std::string& where,
                   const std::vector<int>& unknown = {});

}  // namespace swaplight
