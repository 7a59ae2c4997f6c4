#include "core/solve/estimators/two_lights_kernel.h"

#include "core/simd/lanes.h"

namespace swaplight::SWAPLIGHT_LEVEL {
namespace {

template <bool kPublished>
SWAPLIGHT_LANES void closedForm(const PixelRun& in, const SolvedRun& out, const TwoLightColors& l) {
  for (int at = 0; at < in.count; at += kLanes) {
    Lanes y1[3];
    Lanes y2[3];
    Lanes aa = splat(1e-30F);
    Lanes ab = splat(0);
    for (int c = 0; c < 3; ++c) {
      y1[c] = load(in.signal[0][c] + at);
      y2[c] = load(in.signal[1][c] + at);
      // The residual y1 g2(beta) - y2 g1(beta) = slope beta + offset.
      const Lanes slope = y1[c] * (l.c[c] - l.d[c]) - y2[c] * (l.a[c] - l.b[c]);
      const Lanes offset = y1[c] * l.d[c] - y2[c] * l.b[c];
      aa += slope * slope;
      ab += slope * offset;
    }
    const Lanes beta = smaller(larger(-ab / aa, splat(0)), splat(1));
    for (int c = 0; c < 3; ++c) {
      const Lanes g1 = l.b[c] + beta * (l.a[c] - l.b[c]);
      const Lanes g2 = l.d[c] + beta * (l.c[c] - l.d[c]);
      Lanes rho;
      if constexpr (kPublished)
        rho = y1[c] / (g1 + 0.01F);
      else
        rho = (y1[c] * g1 + y2[c] * g2) / (g1 * g1 + g2 * g2 + 1e-20F);
      rho = larger(rho, splat(0));
      const Lanes first = beta * rho;
      store(out.contribution[0][c] + at, first);
      store(out.contribution[1][c] + at, rho - first);
    }
  }
}

}  // namespace

void closedFormRun(const PixelRun& in, const SolvedRun& out, const TwoLightColors& colors, bool published) {
  published ? closedForm<true>(in, out, colors) : closedForm<false>(in, out, colors);
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
