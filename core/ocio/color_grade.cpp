#include "core/ocio/color_grade.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr double kNoGain = 1e-9;

}  // namespace

bool ColorGrade::idle() const {
  ColorGrade neutral;
  neutral.on = on;
  return !on || *this == neutral;
}

ColorGrade withLiftGammaGain(ColorGrade grade, const LiftGammaGain& values) {
  for (size_t c = 0; c < 3; ++c) {
    grade.slope[c] = std::clamp(values.gain[c] * (1 - values.lift[c]), 0.0, kMostGrade);
    grade.offset[c] = std::clamp(values.gain[c] * values.lift[c], -kMostGrade, kMostGrade);
    grade.power[c] = std::clamp(1 / std::max(values.gamma[c], 1 / kMostGrade), 1 / kMostGrade, kMostGrade);
  }
  return grade;
}

LiftGammaGain liftGammaGainOf(const ColorGrade& grade) {
  LiftGammaGain values;
  for (size_t c = 0; c < 3; ++c) {
    const double gain = grade.slope[c] + grade.offset[c];
    values.gain[c] = gain;
    values.lift[c] = std::abs(gain) < kNoGain ? 0 : grade.offset[c] / gain;
    values.gamma[c] = 1 / grade.power[c];
  }
  return values;
}

}  // namespace swaplight
