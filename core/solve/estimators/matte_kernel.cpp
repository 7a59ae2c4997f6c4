#include "core/solve/estimators/matte_kernel.h"

#include "core/simd/lanes.h"
#include "core/simd/lanes_cholesky.h"

namespace swaplight::SWAPLIGHT_LEVEL {
namespace {

constexpr int kSteps = 5;          // Gauss-Newton steps; from the ridge guess, three are usually enough
constexpr float kGain = 0.03F;     // of chi-square: a step that is to gain less is the last
constexpr float kDamping = 1e-5F;  // relative to the mean curvature
constexpr float kTiny = 1e-20F;
/// Of what all channels together are seen by: what a channel's reflectance is held at 0 by, so that one of
/// which no usable shot sees any light does not become any brightness, and others with it. Lost where a
/// channel is seen at all (14 stops less than the others, by a short exposure: a quarter of a per cent).
constexpr float kUnseen = 1e-11F;
constexpr float kWorst = 1e4F;  // a variance beyond which nothing is known at all

/// A pixel's data, weighted: what Gauss-Newton needs of the shots.
template <int kN>
struct Normal {
  Lanes p[3][kN];
  Lanes q[3][kN * (kN + 1) / 2];
  Lanes energy;  ///< sum of w y^2
};

template <int kN>
SWAPLIGHT_LANES constexpr int packed(int i, int j) {
  return i * (i + 1) / 2 + j;  // j <= i
}

/// Weighted normal equations of a block of pixels, given signal guesses g rho per channel.
template <int kN>
SWAPLIGHT_LANES void accumulate(const MattePlan& plan, const PixelRun& in, int at, int n, const Lanes* u,
                                const Lanes* rho, Normal<kN>& out) {
  out.energy = splat(0);
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < n; ++i) out.p[c][i] = splat(0);
    for (int i = 0; i < n * (n + 1) / 2; ++i) out.q[c][i] = splat(0);
    for (int k = 0; k < plan.shots; ++k) {
      const float* color = plan.color.data() + (k * 3 + c) * n;
      const float* product = plan.product.data() + (k * 3 + c) * (n * (n + 1) / 2);
      Lanes y = load(in.signal[k][c] + at);
      Lanes g = splat(0);
      for (int i = 0; i < n; ++i) g += color[i] * u[i];
      const Lanes s = g * rho[c];
      const LaneMask usable = y == y;
      y = select(usable, y, splat(0));
      const Lanes w =
          select(usable, roughReciprocal(plan.constant + s * (plan.linear + s * plan.square)), splat(0));
      const Lanes wy = w * y;
      out.energy += wy * y;
      for (int i = 0; i < n; ++i) out.p[c][i] += wy * color[i];
      for (int i = 0; i < n * (n + 1) / 2; ++i) out.q[c][i] += w * product[i];
    }
  }
}

/// rho, the explained energy, and the row Q u of each channel at u.
template <int kN>
struct At {
  Lanes rho[3];
  Lanes inverse[3];  ///< 1 / u'Qu
  Lanes qu[3][kN];
  Lanes explained;
};

template <int kN>
SWAPLIGHT_LANES void evaluate(const Normal<kN>& normal, int n, const Lanes* u, At<kN>& at) {
  at.explained = splat(0);
  Lanes seen[3];
  Lanes along[3];
  for (int c = 0; c < 3; ++c) {
    Lanes s = splat(0);
    Lanes a = splat(0);
    for (int i = 0; i < n; ++i) {
      Lanes sum = splat(0);
      for (int j = 0; j < n; ++j) sum += normal.q[c][i >= j ? packed<kN>(i, j) : packed<kN>(j, i)] * u[j];
      at.qu[c][i] = sum;
      s += sum * u[i];
      a += normal.p[c][i] * u[i];
    }
    seen[c] = larger(s, splat(kTiny));  // what is no number counts as nothing
    along[c] = larger(a, splat(0));
  }
  const Lanes least = kUnseen * (seen[0] + seen[1] + seen[2]);
  for (int c = 0; c < 3; ++c) {
    at.inverse[c] = reciprocal(seen[c] + least);
    at.rho[c] = along[c] * at.inverse[c];
    at.explained += along[c] * at.rho[c];
  }
}

/// The reflectance by plain least squares: a guess good enough to predict each value's noise.
template <int kN>
SWAPLIGHT_LANES void plainReflectance(const MattePlan& plan, const PixelRun& in, int at, int n,
                                      const Lanes* u, Lanes* rho) {
  for (int c = 0; c < 3; ++c) {
    Lanes gg = splat(kTiny);
    Lanes gy = splat(0);
    for (int k = 0; k < plan.shots; ++k) {
      const float* color = plan.color.data() + (k * 3 + c) * n;
      const Lanes y = load(in.signal[k][c] + at);
      Lanes g = splat(0);
      for (int i = 0; i < n; ++i) g += color[i] * u[i];
      const LaneMask usable = y == y;
      g = select(usable, g, splat(0));
      gg += g * g;
      gy += g * select(usable, y, splat(0));
    }
    rho[c] = larger(gy * reciprocal(gg), splat(0));
  }
}

/// The first guess: ridge demultiplex, clamped; reflectance by plain least squares.
template <int kN>
SWAPLIGHT_LANES void firstGuess(const MattePlan& plan, const PixelRun& in, int at, int n, Lanes* u,
                                Lanes* rho) {
  for (int i = 0; i < n; ++i) u[i] = splat(0);
  for (int k = 0; k < plan.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      Lanes y = load(in.signal[k][c] + at);
      y = select(y == y, y, splat(0));
      for (int i = 0; i < n; ++i) u[i] += y * plan.guess.data()[(k * 3 + c) * n + i];
    }
  Lanes sum = splat(0);
  for (int i = 0; i < n; ++i) {
    u[i] = larger(u[i], splat(0));
    sum += u[i];
  }
  const LaneMask dark = sum < kTiny;
  sum = 0.96F / select(dark, splat(1), sum);
  for (int i = 0; i < n; ++i) u[i] = select(dark, splat(1.0F / float(n)), u[i] * sum + 0.04F / float(n));
  plainReflectance<kN>(plan, in, at, n, u, rho);
}

/// Kaufman's Hessian and the gradient at u, the gauge added, lights that stay at zero taken out.
template <int kN>
SWAPLIGHT_LANES void curvature(const Normal<kN>& normal, const At<kN>& at, int n, const Lanes* u, bool hold,
                               Lanes* h, Lanes* g) {
  for (int i = 0; i < n; ++i) {
    Lanes slope = splat(0);
    for (int c = 0; c < 3; ++c) slope += at.rho[c] * (normal.p[c][i] - at.rho[c] * at.qu[c][i]);
    g[i] = slope;
  }
  Lanes power[3];
  Lanes across[3][kN];
  for (int c = 0; c < 3; ++c) {
    power[c] = at.rho[c] * at.rho[c];
    const Lanes scale = power[c] * at.inverse[c];
    for (int i = 0; i < n; ++i) across[c][i] = scale * at.qu[c][i];
  }
  Lanes trace = splat(kTiny);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      Lanes sum = splat(0);
      for (int c = 0; c < 3; ++c)
        sum += power[c] * normal.q[c][packed<kN>(i, j)] - across[c][i] * at.qu[c][j];
      h[packed<kN>(i, j)] = sum;
      if (i == j) trace += sum;
    }
  trace *= 1.0F / float(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) h[packed<kN>(i, j)] += i == j ? trace * (1 + kDamping) : trace;
  if (!hold) return;
  for (int i = 0; i < n; ++i) {
    const LaneMask held = (u[i] <= 0) & (g[i] <= 0);
    g[i] = select(held, splat(0), g[i]);
    for (int j = 0; j < n; ++j) {
      Lanes& entry = h[i >= j ? packed<kN>(i, j) : packed<kN>(j, i)];
      entry = select(held, i == j ? trace : splat(0), entry);
    }
  }
}

/// Two shares have one direction to go: what one gains the other loses. The slope and the curvature there.
SWAPLIGHT_LANES void acrossTwo(const Normal<2>& normal, const At<2>& at, Lanes& slope, Lanes& bend) {
  slope = splat(0);
  bend = splat(kTiny);
  for (int c = 0; c < 3; ++c) {
    const Lanes along = at.qu[c][0] - at.qu[c][1];
    slope += at.rho[c] * (normal.p[c][0] - normal.p[c][1] - at.rho[c] * along);
    const Lanes power = at.rho[c] * at.rho[c];
    bend += power * (normal.q[c][0] - 2 * normal.q[c][1] + normal.q[c][2] - at.inverse[c] * along * along);
  }
}

/// The Newton step at u; with `hold`, lights that stay at zero are held there. Returns what it should gain.
template <int kN>
SWAPLIGHT_LANES Lanes newtonStep(const Normal<kN>& normal, const At<kN>& at, int n, const Lanes* u, bool hold,
                                 Lanes* step) {
  if constexpr (kN == 2) {
    Lanes slope;
    Lanes bend;
    acrossTwo(normal, at, slope, bend);
    step[0] = slope * reciprocal(bend);
    if (hold) {
      const LaneMask held = ((u[0] <= 0) & (slope <= 0)) | ((u[1] <= 0) & (slope >= 0));
      step[0] = select(held, splat(0), step[0]);
    }
    step[1] = -step[0];
    return slope * step[0];
  } else {
    Lanes h[kN * (kN + 1) / 2];
    Lanes slope[kN];
    curvature<kN>(normal, at, n, u, hold, h, slope);
    factorCholesky<kN>(n, h);
    for (int i = 0; i < n; ++i) step[i] = slope[i];
    solveCholesky<kN>(n, h, step);
    Lanes gain = splat(0);
    for (int i = 0; i < n; ++i) gain += slope[i] * step[i];
    return gain;
  }
}

/// The covariance of the shares at the maximum: the inverse curvature, without the gauge direction, which is
/// u u' / trace there.
template <int kN>
SWAPLIGHT_LANES void shareCovariance(const Normal<kN>& normal, const At<kN>& at, int n, const Lanes* u,
                                     Lanes (*covariance)[kN]) {
  if constexpr (kN == 2) {
    Lanes slope;
    Lanes bend;
    acrossTwo(normal, at, slope, bend);
    // A share that is held at zero has its variance to itself.
    const Lanes variance = 1 / larger(bend, splat(kTiny));
    const LaneMask held[2] = {(u[0] <= 0) & (slope <= 0), (u[1] <= 0) & (slope >= 0)};
    for (int i = 0; i < 2; ++i) {
      const Lanes own = select(held[i], 2 * variance, select(held[1 - i], splat(0), variance));
      covariance[i][i] = own;
      covariance[i][1 - i] = -own;
    }
  } else {
    Lanes h[kN * (kN + 1) / 2];
    Lanes slope[kN];
    curvature<kN>(normal, at, n, u, true, h, slope);
    factorCholesky<kN>(n, h);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) covariance[i][j] = splat(i == j ? 1 : 0);
      solveCholesky<kN>(n, h, covariance[i], i);
      Lanes gauge = splat(0);
      for (int j = 0; j < n; ++j) gauge += covariance[i][j];
      for (int j = 0; j < n; ++j) covariance[i][j] -= gauge * u[j];
    }
  }
}

/// The variances of MatteRun at the maximum.
template <int kN>
SWAPLIGHT_LANES void variances(const MattePlan& plan, const Normal<kN>& normal, const At<kN>& at, int n,
                               const Lanes* u, Lanes& contribution, Lanes& share) {
  Lanes total = splat(0);
  Lanes slope[kN];  // of R, the sum of rho, along u_j
  Lanes rhoVariance = splat(0);
  for (int c = 0; c < 3; ++c) {
    total += at.rho[c];
    rhoVariance += plan.seen[size_t(c)] * at.inverse[c];
  }
  for (int j = 0; j < n; ++j) {
    slope[j] = splat(0);
    for (int c = 0; c < 3; ++c) slope[j] += (normal.p[c][j] - 2 * at.rho[c] * at.qu[c][j]) * at.inverse[c];
  }
  Lanes covariance[kN][kN];
  shareCovariance<kN>(normal, at, n, u, covariance);
  // t_i = u_i R has the derivative u_i slope + R e_i: its variance is a quadratic form of that. What rounding
  // and held lights leave of the covariance's other half does not count.
  Lanes across[kN];  // twice its symmetric part, times the slope
  Lanes along = splat(0);
  for (int i = 0; i < n; ++i) {
    across[i] = splat(0);
    for (int j = 0; j < n; ++j) across[i] += (covariance[i][j] + covariance[j][i]) * slope[j];
    along += across[i] * slope[i];
  }
  const Lanes ofAll = rhoVariance + 0.5F * along;
  contribution = splat(0);
  share = splat(0);
  for (int i = 0; i < n; ++i) {
    share += larger(covariance[i][i], splat(0));
    const Lanes variance = u[i] * (u[i] * ofAll + total * across[i]) + total * total * covariance[i][i];
    contribution += larger(variance, splat(0));
  }
  contribution = smaller(contribution / (float(n) * larger(total * total, splat(kTiny))), splat(kWorst));
  Lanes signal = splat(0);
  for (int c = 0; c < 3; ++c) {
    Lanes g = splat(0);
    for (int i = 0; i < n; ++i) g += plan.mean.data()[c * n + i] * u[i];
    signal += g * at.rho[c];
  }
  const Lanes own = plan.constant + plan.linear * signal;
  share *= own / ((own + plan.square * signal * signal) * float(n));
  share = smaller(share, splat(kWorst));
}

/// Writes what is known at the maximum, u.
template <int kN>
SWAPLIGHT_LANES void writeFit(const MattePlan& plan, const Normal<kN>& normal, const At<kN>& here, int n,
                              const Lanes* u, const MatteRun& out, int at) {
  for (int c = 0; c < 3; ++c) store(out.reflectance[c] + at, here.rho[c]);
  store(out.misfit + at, larger(normal.energy - here.explained, splat(0)));
  if (!out.variance) return;
  Lanes variance;
  Lanes shareVariance;
  variances<kN>(plan, normal, here, n, u, variance, shareVariance);
  store(out.variance + at, variance);
  store(out.shareVariance + at, shareVariance);
}

/// The step that lights at zero would take if they could be negative.
template <int kN>
SWAPLIGHT_LANES void stepBelowZero(const Normal<kN>& normal, const At<kN>& here, int n, Lanes* u) {
  LaneMask atZero = u[0] <= 0;
  for (int i = 1; i < n; ++i) atZero |= u[i] <= 0;
  if (!any(atZero)) return;
  Lanes step[kN];
  newtonStep<kN>(normal, here, n, u, false, step);
  for (int i = 0; i < n; ++i)
    u[i] = select(atZero, smaller(larger(u[i] + step[i], splat(-1)), splat(2)), u[i]);
}

/// Takes a step; lights >= 0, back to sum 1.
template <int kN>
SWAPLIGHT_LANES void moveShares(int n, const Lanes* u, const Lanes* step, Lanes* next) {
  Lanes sum = splat(kTiny);
  for (int i = 0; i < n; ++i) {
    next[i] = larger(u[i] + step[i], splat(0));
    sum += next[i];
  }
  sum = reciprocal(sum);
  for (int i = 0; i < n; ++i) next[i] *= sum;
}

/// Where the fit of a vector of pixels stands.
template <int kN>
struct Fit {
  Normal<kN> normal;
  Lanes best[kN];
  Lanes step[kN];
  Lanes explained;  ///< energy, at best
  Lanes gain;       ///< expected of the step
};

template <int kN>
SWAPLIGHT_LANES void begin(const MattePlan& plan, const PixelRun& in, int at, int n, Fit<kN>& fit) {
  Lanes rho[3];
  firstGuess<kN>(plan, in, at, n, fit.best, rho);
  accumulate<kN>(plan, in, at, n, fit.best, rho, fit.normal);
  for (int i = 0; i < n; ++i) fit.step[i] = splat(0);
  fit.explained = splat(-1);
  fit.gain = splat(0);
}

/// Takes the step where it helps, and prepares the next one; a shorter one where it did not.
template <int kN>
SWAPLIGHT_LANES void improve(int n, Fit<kN>& fit) {
  Lanes next[kN];
  moveShares<kN>(n, fit.best, fit.step, next);
  At<kN> there;
  evaluate<kN>(fit.normal, n, next, there);
  const LaneMask better = there.explained >= fit.explained;
  fit.explained = select(better, there.explained, fit.explained);
  Lanes newton[kN];
  const Lanes expected = newtonStep<kN>(fit.normal, there, n, next, true, newton);
  fit.gain = select(better, expected, 0.25F * fit.gain);
  for (int i = 0; i < n; ++i) {
    fit.best[i] = select(better, next[i], fit.best[i]);
    fit.step[i] = select(better, newton[i], 0.25F * fit.step[i]);
  }
}

/// A last step, too small to ask whether it helps; then what is known.
template <int kN>
SWAPLIGHT_LANES void finish(const MattePlan& plan, int n, Fit<kN>& fit, const MatteRun& out, int at) {
  const LaneMask small = fit.gain <= kGain;
  for (int i = 0; i < n; ++i) fit.step[i] = select(small, fit.step[i], splat(0));
  moveShares<kN>(n, fit.best, fit.step, fit.best);
  At<kN> here;
  evaluate<kN>(fit.normal, n, fit.best, here);
  writeFit<kN>(plan, fit.normal, here, n, fit.best, out, at);
  if (out.signedShares) stepBelowZero<kN>(fit.normal, here, n, fit.best);
  for (int i = 0; i < n; ++i) store(out.share[i] + at, fit.best[i]);
}

template <int kN>
SWAPLIGHT_LANES void fitRun(const MattePlan& plan, const PixelRun& in, const MatteRun& out, int lights) {
  const int n = lights;
  for (int at = 0; at < in.count; at += kMostLanes) {
    Fit<kN> block[kBlockVectors];
    for (int v = 0; v < kBlockVectors; ++v) begin<kN>(plan, in, at + v * kLanes, n, block[v]);
    for (int iteration = 0;; ++iteration) {
      bool going = false;
      for (Fit<kN>& fit : block) {
        improve<kN>(n, fit);
        going |= any(fit.gain > kGain);
      }
      if (iteration == kSteps || !going) break;
    }
    for (int v = 0; v < kBlockVectors; ++v) finish<kN>(plan, n, block[v], out, at + v * kLanes);
  }
}

/// Everything but the shares, at shares that are given.
template <int kN>
SWAPLIGHT_LANES void assessRun(const MattePlan& plan, const PixelRun& in, const MatteRun& out, int lights) {
  const int n = lights;
  for (int at = 0; at < in.count; at += kLanes) {
    Lanes u[kN];
    Lanes rho[3];
    for (int i = 0; i < n; ++i) u[i] = load(out.share[i] + at);
    plainReflectance<kN>(plan, in, at, n, u, rho);
    Normal<kN> normal;
    accumulate<kN>(plan, in, at, n, u, rho, normal);
    At<kN> here;
    evaluate<kN>(normal, n, u, here);
    writeFit<kN>(plan, normal, here, n, u, out, at);
  }
}

}  // namespace

void fitMatte(const MattePlan& plan, const PixelRun& in, const MatteRun& out) {
  switch (plan.lights) {
    case 2:
      return fitRun<2>(plan, in, out, 2);
    case 3:
      return fitRun<3>(plan, in, out, 3);
    case 4:
      return fitRun<4>(plan, in, out, 4);
    default:
      return fitRun<kMaxLights>(plan, in, out, plan.lights);
  }
}

void assessMatte(const MattePlan& plan, const PixelRun& in, const MatteRun& inOut) {
  switch (plan.lights) {
    case 2:
      return assessRun<2>(plan, in, inOut, 2);
    case 3:
      return assessRun<3>(plan, in, inOut, 3);
    case 4:
      return assessRun<4>(plan, in, inOut, 4);
    default:
      return assessRun<kMaxLights>(plan, in, inOut, plan.lights);
  }
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
