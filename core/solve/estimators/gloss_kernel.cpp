#include "core/solve/estimators/gloss_kernel.h"

#include "core/simd/lanes.h"
#include "core/simd/lanes_cholesky.h"

namespace swaplight::SWAPLIGHT_LEVEL {
namespace {

constexpr int kSteps = 20;
constexpr int kPasses = 2;  // of the active set, a step
constexpr float kDamping = 1e-2F;
constexpr float kGain = 1e-2F;  // of chi-square, that is worth a step
constexpr float kFloor = 1e-7F;
constexpr float kTiny = 1e-15F;
constexpr float kLargest = 4;  // standard deviation of a highlight before anything is known, in reflectances

template <int kN>
struct Pixel {
  Lanes rho[3];
  Lanes share[kN];
  Lanes gloss[kN];
};

/// Normal equations at a pixel's parameters: rho, shares, highlights.
template <int kN>
struct Equations {
  static constexpr int kP = 3 + 2 * kN;
  Lanes h[kP * (kP + 1) / 2];
  Lanes g[kP];
};

template <int kN>
SWAPLIGHT_LANES void linearise(const GlossPlan& plan, const PixelRun& in, const Lanes* weight,
                               Lanes precision, int at, int n, const Pixel<kN>& pixel, Equations<kN>& out) {
  const int params = 3 + 2 * n;
  for (int a = 0; a < params * (params + 1) / 2; ++a) out.h[a] = splat(0);
  for (int a = 0; a < params; ++a) out.g[a] = splat(0);
  for (int k = 0; k < plan.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const float* color = plan.color.data() + (k * 3 + c) * n;
      const Lanes y = load(in.signal[k][c] + at);
      const LaneMask usable = y == y;
      const Lanes w = select(usable, weight[k * 3 + c], splat(0));
      Lanes matte = splat(0);
      Lanes white = splat(0);
      for (int i = 0; i < n; ++i) {
        matte += color[i] * pixel.share[i];
        white += color[i] * pixel.gloss[i];
      }
      const Lanes left = select(usable, y - matte * pixel.rho[c] - white, splat(0));
      // Slopes: matte along rho_c, color rho_c along the shares, color along the highlights.
      const Lanes along = w * left;
      const Lanes tinted = w * pixel.rho[c];
      const Lanes twice = tinted * pixel.rho[c];
      out.g[c] += along * matte;
      out.h[c * (c + 1) / 2 + c] += w * matte * matte;
      for (int i = 0; i < n; ++i) {
        const int b = 3 + i;
        const int l = 3 + n + i;
        out.g[b] += along * pixel.rho[c] * color[i];
        out.g[l] += along * color[i];
        out.h[b * (b + 1) / 2 + c] += tinted * matte * color[i];
        out.h[l * (l + 1) / 2 + c] += w * matte * color[i];
        for (int j = 0; j <= i; ++j) {
          const float product = color[i] * color[j];
          out.h[b * (b + 1) / 2 + 3 + j] += twice * product;
          out.h[l * (l + 1) / 2 + 3 + n + j] += w * product;
        }
        for (int j = 0; j < n; ++j) out.h[l * (l + 1) / 2 + 3 + j] += tinted * (color[i] * color[j]);
      }
    }
  for (int i = 0; i < n; ++i) {
    const int l = 3 + n + i;
    out.g[l] -= precision * pixel.gloss[i];
    out.h[l * (l + 1) / 2 + l] += precision;
  }
}

/// What is left at a pixel's parameters: weighted squares, and the penalty.
template <int kN>
SWAPLIGHT_LANES Lanes costOf(const GlossPlan& plan, const PixelRun& in, const Lanes* weight, Lanes precision,
                             int at, int n, const Pixel<kN>& pixel, Lanes& square) {
  square = splat(0);
  for (int k = 0; k < plan.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const float* color = plan.color.data() + (k * 3 + c) * n;
      const Lanes y = load(in.signal[k][c] + at);
      Lanes left = y;
      for (int i = 0; i < n; ++i) left -= color[i] * (pixel.share[i] * pixel.rho[c] + pixel.gloss[i]);
      square += select(y == y, weight[k * 3 + c] * left * left, splat(0));
    }
  Lanes cost = square;
  for (int i = 0; i < n; ++i) cost += precision * pixel.gloss[i] * pixel.gloss[i];
  return cost;
}

/// Damps, and holds the shares' sum.
template <int kN>
SWAPLIGHT_LANES void restrain(int n, Lanes damping, Equations<kN>& e) {
  const int params = 3 + 2 * n;
  Lanes floor = splat(kTiny);
  for (int a = 0; a < 3; ++a) floor += e.h[a * (a + 1) / 2 + a];
  Lanes trace = splat(0);
  for (int a = 3; a < 3 + n; ++a) trace += e.h[a * (a + 1) / 2 + a];
  trace = trace / float(n) + kFloor * floor;
  for (int a = 3; a < 3 + n; ++a)
    for (int b = 3; b <= a; ++b) e.h[a * (a + 1) / 2 + b] += trace;
  for (int a = 0; a < params; ++a) {
    Lanes& own = e.h[a * (a + 1) / 2 + a];
    own += damping * own + kFloor * floor;
  }
}

/// The step of damped normal equations that takes no share and no highlight below 0: what would go below
/// goes to 0, and the others' steps are taken again. Leaves the factor in e.h.
template <int kN>
SWAPLIGHT_LANES void solveStep(int n, const Pixel<kN>& pixel, Equations<kN>& e, Lanes* step) {
  constexpr int kP = Equations<kN>::kP;
  const int params = 3 + 2 * n;
  Lanes whole[kP * (kP + 1) / 2];
  Lanes slope[kP];
  LaneMask held[kP];
  for (int a = 0; a < params * (params + 1) / 2; ++a) whole[a] = e.h[a];
  for (int a = 0; a < params; ++a) {
    slope[a] = e.g[a];
    held[a] = splat(0) > splat(0);
  }
  for (int pass = 0;; ++pass) {
    factorCholesky<kP>(params, e.h);
    for (int a = 0; a < params; ++a) step[a] = e.g[a];
    solveCholesky<kP>(params, e.h, step);
    if (pass == kPasses) return;
    LaneMask changed = held[0];
    for (int a = 3; a < params; ++a) {
      const Lanes value = a < 3 + n ? pixel.share[a - 3] : pixel.gloss[a - 3 - n];
      const LaneMask below = (value + step[a] < 0) & ~held[a];
      changed |= below;
      held[a] |= below;
    }
    if (!any(changed)) return;
    for (int a = 0; a < params * (params + 1) / 2; ++a) e.h[a] = whole[a];
    for (int a = 0; a < params; ++a) e.g[a] = slope[a];
    for (int a = 3; a < params; ++a) {
      if (!any(held[a])) continue;
      const Lanes value = a < 3 + n ? pixel.share[a - 3] : pixel.gloss[a - 3 - n];
      for (int b = 0; b < params; ++b) {
        Lanes& entry = e.h[a >= b ? a * (a + 1) / 2 + b : b * (b + 1) / 2 + a];
        if (a == b) continue;
        e.g[b] += select(held[a], entry * value, splat(0));
        entry = select(held[a], splat(0), entry);
      }
      e.g[a] = select(held[a], -value * e.h[a * (a + 1) / 2 + a], e.g[a]);
    }
  }
}

template <int kN>
SWAPLIGHT_LANES void take(int n, const Lanes* step, Pixel<kN>& pixel) {
  Lanes sum = splat(kTiny);
  for (int i = 0; i < n; ++i) {
    pixel.share[i] = larger(pixel.share[i] + step[3 + i], splat(0));
    pixel.gloss[i] = larger(pixel.gloss[i] + step[3 + n + i], splat(0));
    sum += pixel.share[i];
  }
  for (int c = 0; c < 3; ++c) pixel.rho[c] = larger((pixel.rho[c] + step[c]) * sum, splat(0));
  sum = 1 / sum;
  for (int i = 0; i < n; ++i) pixel.share[i] *= sum;
}

/// Of a light's contribution, mean of the channels, averaged over the lights; over the square of the sum.
template <int kN>
SWAPLIGHT_LANES Lanes relativeVariance(int n, const Pixel<kN>& pixel, const Lanes* factor) {
  constexpr int kP = Equations<kN>::kP;
  const Lanes mean = (pixel.rho[0] + pixel.rho[1] + pixel.rho[2]) / 3;
  Lanes total = mean;
  Lanes variance = splat(0);
  for (int i = 0; i < n; ++i) {
    total += pixel.gloss[i];
    Lanes slope[kP];
    Lanes solved[kP];
    for (int a = 0; a < 3 + 2 * n; ++a) slope[a] = splat(0);
    for (int c = 0; c < 3; ++c) slope[c] = pixel.share[i] / 3;
    slope[3 + i] = mean;
    slope[3 + n + i] = splat(1);
    for (int a = 0; a < 3 + 2 * n; ++a) solved[a] = slope[a];
    solveCholesky<kP>(3 + 2 * n, factor, solved);
    for (int a = 0; a < 3 + 2 * n; ++a) variance += larger(slope[a] * solved[a], splat(0));
  }
  // Over the sum of the channels, as quality.sigma is.
  return variance / (float(n) * larger(total * total, splat(kTiny)));
}

/// Where the fit of a vector of pixels stands.
template <int kN>
struct Fit {
  Pixel<kN> best;
  Lanes weight[3 * kMaxShots];  ///< of each value, from its noise as the matte fit predicts the signal
  Lanes precision;              ///< of what is known of a highlight before
  Lanes cost;
  Lanes square;
  Lanes damping;
};

template <int kN>
SWAPLIGHT_LANES void begin(const GlossPlan& plan, const PixelRun& in, const MatteRun& matte, int at, int n,
                           Fit<kN>& fit) {
  Pixel<kN>& best = fit.best;
  for (int c = 0; c < 3; ++c) best.rho[c] = load(matte.reflectance[c] + at);
  for (int i = 0; i < n; ++i) {
    best.share[i] = load(matte.share[i] + at);
    best.gloss[i] = splat(0);
  }
  for (int k = 0; k < plan.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      Lanes g = splat(0);
      for (int i = 0; i < n; ++i) g += plan.color.data()[(k * 3 + c) * n + i] * best.share[i];
      const Lanes s = g * best.rho[c];
      fit.weight[k * 3 + c] = 1 / (plan.constant + s * (plan.linear + s * plan.square));
    }
  const Lanes bright = (best.rho[0] + best.rho[1] + best.rho[2]) / 3;
  fit.precision = 1 / (kLargest * kLargest * bright * bright + plan.constant);
  fit.cost = costOf<kN>(plan, in, fit.weight, fit.precision, at, n, best, fit.square);
  fit.damping = splat(kDamping);
}

/// A damped step (Levenberg and Marquardt), kept where it helps; whether any pixel gained by it.
template <int kN>
SWAPLIGHT_LANES bool improve(const GlossPlan& plan, const PixelRun& in, int at, int n, Fit<kN>& fit) {
  Equations<kN> e;
  Lanes step[Equations<kN>::kP];
  linearise<kN>(plan, in, fit.weight, fit.precision, at, n, fit.best, e);
  restrain<kN>(n, fit.damping, e);
  solveStep<kN>(n, fit.best, e, step);
  Pixel<kN> next = fit.best;
  take<kN>(n, step, next);
  Lanes left;
  const Lanes there = costOf<kN>(plan, in, fit.weight, fit.precision, at, n, next, left);
  const LaneMask better = there < fit.cost;
  const bool moving = any(there < fit.cost - kGain);
  fit.cost = select(better, there, fit.cost);
  fit.square = select(better, left, fit.square);
  fit.damping = select(better, fit.damping * .2F, fit.damping * 10);
  for (int c = 0; c < 3; ++c) fit.best.rho[c] = select(better, next.rho[c], fit.best.rho[c]);
  for (int i = 0; i < n; ++i) {
    fit.best.share[i] = select(better, next.share[i], fit.best.share[i]);
    fit.best.gloss[i] = select(better, next.gloss[i], fit.best.gloss[i]);
  }
  return moving;
}

template <int kN>
SWAPLIGHT_LANES void finish(const GlossPlan& plan, const PixelRun& in, int at, int n, const Fit<kN>& fit,
                            const SolvedRun& out) {
  constexpr int kP = Equations<kN>::kP;
  Equations<kN> e;
  linearise<kN>(plan, in, fit.weight, fit.precision, at, n, fit.best, e);
  restrain<kN>(n, splat(0), e);
  factorCholesky<kP>(3 + 2 * n, e.h);
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c)
      store(out.contribution[i][c] + at, fit.best.share[i] * fit.best.rho[c] + fit.best.gloss[i]);
  store(out.residual + at, fit.square);
  store(out.sigma + at, relativeVariance<kN>(n, fit.best, e.h));
}

template <int kN>
SWAPLIGHT_LANES void fitRun(const GlossPlan& plan, const PixelRun& in, const MatteRun& matte,
                            const SolvedRun& out, int lights) {
  const int n = lights;
  for (int at = 0; at < in.count; at += kMostLanes) {
    Fit<kN> block[kBlockVectors];
    for (int v = 0; v < kBlockVectors; ++v) begin<kN>(plan, in, matte, at + v * kLanes, n, block[v]);
    for (int iteration = 0; iteration < kSteps; ++iteration) {
      bool moving = false;
      for (int v = 0; v < kBlockVectors; ++v) moving |= improve<kN>(plan, in, at + v * kLanes, n, block[v]);
      if (!moving && iteration > 2) break;
    }
    for (int v = 0; v < kBlockVectors; ++v) finish<kN>(plan, in, at + v * kLanes, n, block[v], out);
  }
}

}  // namespace

void fitGloss(const GlossPlan& plan, const PixelRun& in, const MatteRun& matte, const SolvedRun& out) {
  switch (plan.lights) {
    case 2:
      return fitRun<2>(plan, in, matte, out, 2);
    case 3:
      return fitRun<3>(plan, in, matte, out, 3);
    case 4:
      return fitRun<4>(plan, in, matte, out, 4);
    default:
      return fitRun<kMaxLights>(plan, in, matte, out, plan.lights);
  }
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
