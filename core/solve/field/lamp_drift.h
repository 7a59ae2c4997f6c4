#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/capture/smooth_field.h"

namespace swaplight {

/// The colour of every lamp over the picture, as far as it is no level: the logarithm is a polynomial of
/// degree 2 in x and y in two directions of chromaticity, orthogonal to a change of all channels alike.
class LampDrift {
 public:
  static constexpr int kTerms = 5;  ///< x, y, x^2, xy, y^2; the even ones less their mean
  static constexpr int kChromas = 2;
  using Terms = Eigen::Matrix<double, kTerms, 1>;

  explicit LampDrift(int lights) : m_unknowns(Eigen::VectorXd::Zero(kTerms * kChromas * lights)) {}
  LampDrift(int lights, Eigen::VectorXd unknowns);

  [[nodiscard]] int lights() const { return int(m_unknowns.size()) / (kTerms * kChromas); }
  /// As indexed by at().
  [[nodiscard]] const Eigen::VectorXd& unknowns() const { return m_unknowns; }
  [[nodiscard]] static int at(int light, int term, int chroma) {
    return (light * kTerms + term) * kChromas + chroma;
  }
  /// x, y from -1 (left, top edge) to 1.
  [[nodiscard]] static Terms terms(double x, double y);
  /// What a chroma adds to the logarithm of a channel; of unit length.
  [[nodiscard]] static double chroma(int which, int channel);

  /// The lamp's colour over its mean.
  [[nodiscard]] std::array<double, 3> factor(int light, const Terms& terms) const;
  /// The same as a field whose luminance, to first order, is the same everywhere.
  [[nodiscard]] SmoothField field(int light) const;
  /// RMS of the logarithm of a lamp's colour over the picture.
  [[nodiscard]] double size(int light) const;

 private:
  Eigen::VectorXd m_unknowns;
};

}  // namespace swaplight
