#include "core/solve/field/lamp_drift.h"

#include <cmath>

#include "core/base/check.h"
#include "core/color/chromaticity.h"

namespace swaplight {
namespace {

constexpr int kPlaces = 24;  // a side, over which a size is the mean

/// The logarithm of each channel of a colour, the same luminance everywhere to first order: what is
/// polynomial stays so.
using Polynomials = std::array<LampDrift::Terms, 3>;

Polynomials evenLuminance(const LampDrift& drift, int light) {
  Polynomials channels;
  for (int c = 0; c < 3; ++c)
    for (int t = 0; t < LampDrift::kTerms; ++t) {
      double sum = 0;
      for (int a = 0; a < LampDrift::kChromas; ++a)
        sum += LampDrift::chroma(a, c) * drift.unknowns()[LampDrift::at(light, t, a)];
      channels[size_t(c)][t] = sum;
    }
  const LampDrift::Terms level = luminance(Rgb(1, 0, 0)) * channels[0] +
                                 luminance(Rgb(0, 1, 0)) * channels[1] +
                                 luminance(Rgb(0, 0, 1)) * channels[2];
  for (LampDrift::Terms& channel : channels) channel -= level;
  return channels;
}

}  // namespace

LampDrift::LampDrift(int lights, Eigen::VectorXd unknowns) : m_unknowns(std::move(unknowns)) {
  SWAPLIGHT_CHECK_EQ(int(m_unknowns.size()), kTerms * kChromas * lights);
}

LampDrift::Terms LampDrift::terms(double x, double y) {
  Terms terms;
  terms << x, y, 1.5 * x * x - .5, x * y, 1.5 * y * y - .5;
  return terms;
}

double LampDrift::chroma(int which, int channel) {
  static const double kChroma[kChromas][3] = {{1 / std::sqrt(2.0), -1 / std::sqrt(2.0), 0},
                                              {1 / std::sqrt(6.0), 1 / std::sqrt(6.0), -2 / std::sqrt(6.0)}};
  return kChroma[which][channel];
}

std::array<double, 3> LampDrift::factor(int light, const Terms& terms) const {
  double sums[kChromas] = {};
  for (int t = 0; t < kTerms; ++t)
    for (int a = 0; a < kChromas; ++a) sums[a] += terms[t] * m_unknowns[at(light, t, a)];
  std::array<double, 3> factor{};
  for (int c = 0; c < 3; ++c) factor[size_t(c)] = std::exp(sums[0] * chroma(0, c) + sums[1] * chroma(1, c));
  return factor;
}

SmoothField LampDrift::field(int light) const {
  std::array<std::array<double, SmoothField::kTerms>, 3> powers{};  // 1, x, y, x^2, xy, y^2, ...
  const Polynomials channels = evenLuminance(*this, light);
  for (size_t c = 0; c < 3; ++c) {
    const Terms& t = channels[c];
    powers[c] = {-.5 * (t[2] + t[4]), t[0], t[1], 1.5 * t[2], t[3], 1.5 * t[4]};
  }
  return SmoothField(powers);
}

double LampDrift::size(int light) const {
  const Polynomials channels = evenLuminance(*this, light);
  double squares = 0;
  for (int j = 0; j < kPlaces * kPlaces; ++j) {
    const Terms where =
        terms((2.0 * (j % kPlaces) + 1) / kPlaces - 1, (2.0 * (j / kPlaces) + 1) / kPlaces - 1);
    for (const Terms& channel : channels) squares += std::pow(channel.dot(where), 2);
  }
  return std::sqrt(squares / (3 * kPlaces * kPlaces));
}

}  // namespace swaplight
