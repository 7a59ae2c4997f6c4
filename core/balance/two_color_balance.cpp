#include "core/balance/two_color_balance.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr float kDarkestChannel = 0.02F;  // of the brightest channel of the light: below, a quotient is noise

/// a and b >= 0 of the least squares fit y = a l_1 + b l_2.
struct TwoColorFit {
  TwoColorFit(const Rgb& first, const Rgb& second)
      : l1(first), l2(second), g11(dot(first, first)), g12(dot(first, second)), g22(dot(second, second)) {}

  /// a / (a + b); 1/2 for black.
  [[nodiscard]] float share(const Rgb& y) const {
    const float p1 = dot(y, l1), p2 = dot(y, l2);
    const float determinant = g11 * g22 - g12 * g12;
    const float a = (g22 * p1 - g12 * p2) / determinant, b = (g11 * p2 - g12 * p1) / determinant;
    if (b <= 0 && a <= 0) return 0.5F;
    if (b <= 0) return 1;
    if (a <= 0) return 0;
    return a / (a + b);
  }

  Rgb l1, l2;
  float g11, g12, g22;
};

}  // namespace

bool tellTwoLampsApart(const Rgb& first, const Rgb& second) {
  constexpr float kDegree = 0.01745F;
  const Rgb a = glm::normalize(first), b = glm::normalize(second);
  return glm::length(glm::cross(a, b)) > kDegree;
}

TwoColorBalance balanceByTwoColors(const Image& photograph, const Rgb& first, const Rgb& second,
                                   const Rgb& white, const Rgb& luminanceWeights) {
  TwoColorBalance balanced{photograph.clone(),
                           Image({photograph.width(), photograph.height(), {"Y"}, "data"})};
  // Proportions are of the lamps' light, whatever their levels: both at one luminance.
  const Rgb one = first / dot(first, luminanceWeights), two = second / dot(second, luminanceWeights);
  const Rgb target = white / dot(white, luminanceWeights);
  const TwoColorFit fit(one, two);
  parallelRows(photograph.height(), 64, [&](int begin, int end) {
    const auto width = size_t(photograph.width());
    for (size_t p = size_t(begin) * width; p < size_t(end) * width; ++p) {
      Rgb y(photograph.plane(0)[p], photograph.plane(1)[p], photograph.plane(2)[p]);
      for (int c = 0; c < 3; ++c)
        if (!std::isfinite(y[c])) y[c] = 0;
      const float beta = fit.share(y);
      const Rgb light = beta * one + (1 - beta) * two;
      const Rgb floored = glm::max(light, Rgb(kDarkestChannel * std::max({light.r, light.g, light.b})));
      const Rgb out = glm::max(Rgb(0), y * (target * dot(light, luminanceWeights) / floored));
      for (int c = 0; c < 3; ++c) balanced.picture.plane(c)[p] = out[c];
      balanced.beta.plane(0)[p] = beta;
    }
  });
  return balanced;
}

}  // namespace swaplight
