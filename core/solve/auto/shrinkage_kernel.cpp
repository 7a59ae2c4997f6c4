#include "core/solve/auto/shrinkage_kernel.h"

#include "core/simd/lanes.h"
#include "core/simd/lanes_cholesky.h"

namespace swaplight::SWAPLIGHT_LEVEL {
namespace {

constexpr int kScales = ShrinkagePrior::kScales;
constexpr float kTiny = 1e-20F;
constexpr float kLeastNormal = 1.2e-38F;

/// A pixel in the coordinates that make its covariance diagonal.
template <int kN>
struct Modes {
  static constexpr int kD = 3 * kN;  ///< unknown contributions
  static constexpr int kP = kN + 3;  ///< parameters of the matte model: rho (whitened), then beta
  Lanes residual[kD];                ///< z - s x at the matte fit
  Lanes x[kD];                       ///< the matte fit
  Lanes slope[kD][kP];               ///< of x along the parameters
  LaneMask held[kN];                 ///< lights at zero
  Lanes noise;                       ///< v
};

template <int kN>
SWAPLIGHT_LANES void toModes(const ShrinkagePlan& plan, const PixelRun& in, const MatteRun& matte, int at,
                             int n, Modes<kN>& out) {
  const int d = 3 * n;
  Lanes u[kN];
  Lanes rho[3];
  for (int i = 0; i < n; ++i) {
    u[i] = load(matte.share[i] + at);
    out.held[i] = u[i] <= 0;
  }
  for (int c = 0; c < 3; ++c) rho[c] = load(matte.reflectance[c] + at);

  // The shots along the modes, and the noise of this pixel.
  for (int m = 0; m < d; ++m) out.residual[m] = splat(0);
  out.noise = splat(0);
  for (int k = 0; k < plan.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const int kc = k * 3 + c;
      Lanes g = splat(0);
      for (int i = 0; i < n; ++i) g += plan.color.data()[kc * n + i] * u[i];
      const Lanes s = g * rho[c];
      out.noise += plan.shape.data()[kc] * (plan.constant + s * (plan.linear + s * plan.square));
      // A value that is left out is as the matte model predicts it.
      Lanes y = load(in.signal[k][c] + at);
      y = select(y == y, y, s);
      for (int m = 0; m < d; ++m) out.residual[m] += plan.toModes.data()[m * 3 * plan.shots + kc] * y;
    }
  out.noise = out.noise / float(3 * plan.shots);

  Lanes white[3];
  for (int c = 0; c < 3; ++c)
    white[c] = plan.whiten.data()[c * 3] * rho[0] + plan.whiten.data()[c * 3 + 1] * rho[1] +
               plan.whiten.data()[c * 3 + 2] * rho[2];
  for (int m = 0; m < d; ++m) {
    const float* mode = plan.modes.data() + m * d;
    out.x[m] = splat(0);
    for (int c = 0; c < 3; ++c) {
      Lanes sum = splat(0);
      for (int i = 0; i < n; ++i) sum += mode[i * 3 + c] * u[i];
      out.slope[m][c] = sum;
      out.x[m] += sum * white[c];
    }
    for (int i = 0; i < n; ++i)
      out.slope[m][3 + i] = mode[i * 3] * white[0] + mode[i * 3 + 1] * white[1] + mode[i * 3 + 2] * white[2];
    out.residual[m] -= plan.singular.data()[m] * out.x[m];
  }
}

/// Refits the matte parameters under S(tau) by one step; gives log evidence and the answer along the modes.
template <int kN>
SWAPLIGHT_LANES Lanes refit(const ShrinkagePlan& plan, const Modes<kN>& pixel, int n, float tau,
                            Lanes* answer) {
  constexpr int kP = Modes<kN>::kP;
  const int d = 3 * n;
  const int params = n + 3;
  const float tau2 = tau * tau;
  Lanes h[kP * (kP + 1) / 2];
  Lanes step[kP];
  for (int a = 0; a < params * (params + 1) / 2; ++a) h[a] = splat(0);
  for (int a = 0; a < params; ++a) step[a] = splat(0);
  Lanes logWeight = splat(0);  // over that of no tau, which the evidence of every tau has
  Lanes weights = splat(1);
  for (int m = 0; m < d; ++m) {
    const float s = plan.singular.data()[m];
    const Lanes weight = reciprocal(s * s * tau2 + pixel.noise);
    weights *= weight * pixel.noise;
    if (m % 3 == 2) {  // as many as a float surely holds
      logWeight += logarithm(larger(weights, splat(kLeastNormal)));
      weights = splat(1);
    }
    const Lanes sw = s * weight;
    const Lanes ssw = s * sw;
    const Lanes along = sw * pixel.residual[m];
    for (int a = 0; a < params; ++a) {
      step[a] += along * pixel.slope[m][a];
      const Lanes scaled = ssw * pixel.slope[m][a];
      for (int b = 0; b <= a; ++b) h[a * (a + 1) / 2 + b] += scaled * pixel.slope[m][b];
    }
  }
  // Shares keep their sum; lights at zero that want to be negative stay there.
  Lanes trace = splat(kTiny);
  Lanes rhoTrace = splat(kTiny);
  for (int a = 0; a < 3; ++a) rhoTrace += h[a * (a + 1) / 2 + a];
  for (int a = 3; a < params; ++a) trace += h[a * (a + 1) / 2 + a];
  trace = trace / float(n);
  rhoTrace = rhoTrace / 3;
  for (int a = 0; a < params; ++a)
    for (int b = 0; b <= a; ++b) {
      Lanes& entry = h[a * (a + 1) / 2 + b];
      if (b >= 3) entry += trace;
      // What is not seen has a slope of its own, the same for every tau: it is no evidence.
      if (a == b)
        entry +=
            a < 3 ? 1e-5F * rhoTrace * (1 - plan.unseen[size_t(a)]) + plan.unseen[size_t(a)] : 1e-5F * trace;
    }
  for (int i = 0; i < n; ++i) {
    const int a = 3 + i;
    const LaneMask held = pixel.held[i] & (step[a] <= 0);
    if (!any(held)) continue;
    step[a] = select(held, splat(0), step[a]);
    for (int b = 0; b < params; ++b) {
      Lanes& entry = h[a >= b ? a * (a + 1) / 2 + b : b * (b + 1) / 2 + a];
      entry = select(held, a == b ? trace : splat(0), entry);
    }
  }
  factorCholesky<kP>(params, h);
  // The factor's diagonal is 1 / D; two at a time, as a float holds.
  Lanes logDeterminant = -logarithm(trace);  // the gauge's own scale
  for (int a = 0; a < params; a += 2) {
    Lanes inverse = h[a * (a + 1) / 2 + a];
    if (a + 1 < params) inverse *= h[(a + 1) * (a + 2) / 2 + a + 1];
    logDeterminant -= logarithm(larger(inverse, splat(kLeastNormal)));
  }
  solveCholesky<kP>(params, h, step);
  Lanes square = splat(0);
  for (int m = 0; m < d; ++m) {
    const float s = plan.singular.data()[m];
    const Lanes weight = reciprocal(s * s * tau2 + pixel.noise);
    Lanes moved = splat(0);
    for (int a = 0; a < params; ++a) moved += pixel.slope[m][a] * step[a];
    const Lanes left = pixel.residual[m] - s * moved;
    square += left * left * weight;
    answer[m] = pixel.x[m] + moved + tau2 * s * weight * left;
  }
  return 0.5F * (logWeight - square - logDeterminant);
}

template <int kN>
[[gnu::always_inline]] inline void shrink(const ShrinkagePlan& plan, const PixelRun& in,
                                          const MatteRun& matte, const float* odds, const float* noise,
                                          const ShrinkageRun& out, int lights) {
  constexpr int kD = Modes<kN>::kD;
  const int n = lights;
  const int d = 3 * n;
  for (int at = 0; at < in.count; at += kLanes) {
    Modes<kN> pixel;
    toModes<kN>(plan, in, matte, at, n, pixel);
    if (noise) pixel.noise *= load(noise + at);
    Lanes answer[kD];
    Lanes mixed[kD];
    Lanes evidence[kScales];
    // Answers are mixed as they come: weights relative to the first, which is the matte one.
    for (int m = 0; m < d; ++m) mixed[m] = splat(0);
    evidence[0] = refit<kN>(plan, pixel, n, plan.prior.scale[0], answer);
    const Lanes prior = odds ? load(odds + at) : splat(1);
    Lanes sum = splat(plan.prior.weight[0]);
    Lanes variance = splat(0);
    for (int j = 1; j < kScales; ++j) {
      const float tau = plan.prior.scale[size_t(j)];
      evidence[j] = refit<kN>(plan, pixel, n, tau, answer);
      const Lanes weight = plan.prior.weight[size_t(j)] * prior *
                           exponential(smaller(larger(evidence[j] - evidence[0], splat(-60)), splat(60)));
      Lanes posterior = splat(0);
      for (int m = 0; m < d; ++m) {
        const float s = plan.singular.data()[m];
        mixed[m] += weight * answer[m];
        posterior += plan.greyPower.data()[m] * tau * tau * pixel.noise / (s * s * tau * tau + pixel.noise);
      }
      variance += weight * posterior;
      sum += weight;
    }
    if (out.logEvidence[0])
      for (int j = 0; j < kScales; ++j) store(out.logEvidence[j] + at, evidence[j]);
    if (!out.solved) continue;
    const Lanes scale = 1 / larger(sum, splat(kTiny));
    const Lanes matteWeight = plan.prior.weight[0] * scale;
    if (out.notMatte) store(out.notMatte + at, 1 - matteWeight);
    for (int m = 0; m < d; ++m) mixed[m] *= scale;
    Lanes total = splat(0);
    for (int i = 0; i < n; ++i)
      for (int c = 0; c < 3; ++c) {
        Lanes t = matteWeight * load(matte.share[i] + at) * load(matte.reflectance[c] + at);
        const float* back = plan.fromModes.data() + (i * 3 + c) * d;
        for (int m = 0; m < d; ++m) t += back[m] * mixed[m];
        t = larger(t, splat(0));
        total += t;
        store(out.solved->contribution[i][c] + at, t);
      }
    const Lanes greyMixed = larger(total, splat(kTiny));
    // Variance of the matte part, relative to its own sum, and of what was added to it.
    const Lanes relative = load(matte.variance + at) + variance * scale / (greyMixed * greyMixed);
    store(out.solved->sigma + at, squareRoot(smaller(relative, splat(1e4F))));
  }
}

}  // namespace

void shrinkRun(const ShrinkagePlan& plan, const PixelRun& in, const MatteRun& matte, const float* odds,
               const float* noise, const ShrinkageRun& out) {
  switch (plan.lights) {
    case 2:
      shrink<2>(plan, in, matte, odds, noise, out, 2);
      break;
    case 3:
      shrink<3>(plan, in, matte, odds, noise, out, 3);
      break;
    case 4:
      shrink<4>(plan, in, matte, odds, noise, out, 4);
      break;
    default:
      shrink<kMaxLights>(plan, in, matte, odds, noise, out, plan.lights);
  }
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
