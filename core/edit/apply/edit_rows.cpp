#include "core/edit/apply/edit_rows.h"

#include <algorithm>

#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr float kNothing = 1e-20f;
constexpr float kTrace = 1e-12f;

SWAPLIGHT_SIMD(void, betaOf,
               (const float* __restrict r, const float* __restrict g, const float* __restrict b,
                const float* __restrict inverseGrey, int count, float* __restrict beta),
               (r, g, b, inverseGrey, count, beta)) {
  for (int i = 0; i < count; ++i) beta[i] = (r[i] + g[i] + b[i]) * inverseGrey[i];
}

SWAPLIGHT_SIMD(void, addTo,
               (float* __restrict r, float* __restrict g, float* __restrict b, const float* __restrict wr,
                const float* __restrict wg, const float* __restrict wb, const float* __restrict beta,
                const float* __restrict target, const float* __restrict mask, int count),
               (r, g, b, wr, wg, wb, beta, target, mask, count)) {
  for (int i = 0; i < count; ++i) {
    const float step = mask[i] * (target[i] - beta[i]);
    const float gain = step > 0 ? step : 0.f;
    const float keep = step < 0 && beta[i] > 0 ? 1 + step / beta[i] : 1.f;
    r[i] = r[i] * keep + gain * wr[i];
    g[i] = g[i] * keep + gain * wg[i];
    b[i] = b[i] * keep + gain * wb[i];
  }
}

// target = beta moved by the mask; its sum is added up. A trace of beta stays, so that lights that are all
// asked to go keep their proportions where there is no other light to take over.
SWAPLIGHT_SIMD(void, moveTarget,
               (const float* __restrict beta, const float* __restrict mask, int count,
                float* __restrict target, float* __restrict sum),
               (beta, mask, count, target, sum)) {
  for (int i = 0; i < count; ++i) {
    const float moved = beta[i] + mask[i] * (target[i] - beta[i]);
    const float trace = kTrace * beta[i];
    target[i] = moved > trace ? moved : trace;
    sum[i] += target[i];
  }
}

SWAPLIGHT_SIMD(void, accumulate, (const float* __restrict in, int count, float* __restrict sum),
               (in, count, sum)) {
  for (int i = 0; i < count; ++i) sum[i] += in[i];
}

// The factor on the chosen lights' targets (no more light than there is), that on the others, and what each
// of the others gets where none of them has light.
SWAPLIGHT_SIMD(void, shareOut,
               (const float* __restrict chosen, const float* __restrict others, int otherCount, int count,
                float* __restrict wanted, float* __restrict otherFactor, float* __restrict otherGift),
               (chosen, others, otherCount, count, wanted, otherFactor, otherGift)) {
  const float perOther = otherCount > 0 ? 1.f / static_cast<float>(otherCount) : 0.f;
  for (int i = 0; i < count; ++i) {
    const float all = chosen[i] + others[i];
    // Without other lights everything stays with the chosen ones.
    const float mine = otherCount > 0 ? (wanted[i] < all ? wanted[i] : all) : all;
    const float rest = all - mine;
    wanted[i] = wanted[i] > kNothing ? mine / wanted[i] : 0.f;
    otherFactor[i] = others[i] > kNothing ? rest / others[i] : 0.f;
    otherGift[i] = others[i] > kNothing ? 0.f : rest * perOther;
  }
}

// What a light keeps, and gains; what it loses goes into the pot.
SWAPLIGHT_SIMD(void, takeAway,
               (float* __restrict r, float* __restrict g, float* __restrict b, const float* __restrict beta,
                const float* __restrict mask, int count, float* __restrict target, float* __restrict gains,
                float* __restrict potR, float* __restrict potG, float* __restrict potB),
               (r, g, b, beta, mask, count, target, gains, potR, potG, potB)) {
  for (int i = 0; i < count; ++i) {
    const float step = mask[i] > 0 ? target[i] - beta[i] : 0.f;
    const float lost = step < 0 && beta[i] > 0 ? -step / beta[i] : 0.f;
    const float gain = step > 0 ? step : 0.f;
    target[i] = gain;
    gains[i] += gain;
    const float lr = r[i] * lost;
    const float lg = g[i] * lost;
    const float lb = b[i] * lost;
    potR[i] += lr;
    potG[i] += lg;
    potB[i] += lb;
    r[i] -= lr;
    g[i] -= lg;
    b[i] -= lb;
  }
}

SWAPLIGHT_SIMD(void, giveOut,
               (const float* __restrict gain, const float* __restrict gains, const float* __restrict potR,
                const float* __restrict potG, const float* __restrict potB, int count, float* __restrict r,
                float* __restrict g, float* __restrict b),
               (gain, gains, potR, potG, potB, count, r, g, b)) {
  for (int i = 0; i < count; ++i) {
    const float share = gains[i] > kNothing ? gain[i] / gains[i] : 0.f;
    r[i] += share * potR[i];
    g[i] += share * potG[i];
    b[i] += share * potB[i];
  }
}

SWAPLIGHT_SIMD(void, scaleBy, (const float* __restrict factor, int count, float* __restrict values),
               (factor, count, values)) {
  for (int i = 0; i < count; ++i) values[i] *= factor[i];
}

SWAPLIGHT_SIMD(void, scaleAndAdd,
               (const float* __restrict beta, const float* __restrict factor, const float* __restrict gift,
                int count, float* __restrict target),
               (beta, factor, gift, count, target)) {
  for (int i = 0; i < count; ++i) target[i] = beta[i] * factor[i] + gift[i];
}

}  // namespace

void betaOfRow(const ConstRgbRow& light, const float* inverseGrey, int count, float* beta) {
  betaOf(light.r, light.g, light.b, inverseGrey, count, beta);
}

void addRow(const RgbRow& light, const ConstRgbRow& white, const float* beta, const float* target,
            const float* mask, int count) {
  addTo(light.r, light.g, light.b, white.r, white.g, white.b, beta, target, mask, count);
}

ShareScratch::ShareScratch(size_t lights, size_t pixels)
    : beta(lights, std::vector<float>(pixels)),
      target(beta),
      chosen(pixels),
      others(pixels),
      wanted(pixels),
      otherFactor(pixels),
      otherGift(pixels),
      gains(pixels),
      potR(pixels),
      potG(pixels),
      potB(pixels) {}

void shareRow(const std::vector<RgbRow>& lights, const std::vector<int>& chosen, const float* mask, int count,
              ShareScratch& s) {
  const auto isChosen = [&](size_t i) {
    return std::binary_search(chosen.begin(), chosen.end(), static_cast<int>(i));
  };
  for (auto* sum : {&s.chosen, &s.others, &s.wanted, &s.gains, &s.potR, &s.potG, &s.potB})
    std::fill_n(sum->begin(), count, 0.f);

  // What the chosen lights want, and what there is for them.
  for (size_t i = 0; i < lights.size(); ++i) {
    accumulate(s.beta[i].data(), count, isChosen(i) ? s.chosen.data() : s.others.data());
    if (isChosen(i)) moveTarget(s.beta[i].data(), mask, count, s.target[i].data(), s.wanted.data());
  }
  shareOut(s.chosen.data(), s.others.data(), static_cast<int>(lights.size() - chosen.size()), count,
           s.wanted.data(), s.otherFactor.data(), s.otherGift.data());
  for (size_t i = 0; i < lights.size(); ++i)
    if (isChosen(i))
      scaleBy(s.wanted.data(), count, s.target[i].data());
    else
      scaleAndAdd(s.beta[i].data(), s.otherFactor.data(), s.otherGift.data(), count, s.target[i].data());

  // Collect from those who lose, give to those who gain.
  for (size_t i = 0; i < lights.size(); ++i)
    takeAway(lights[i].r, lights[i].g, lights[i].b, s.beta[i].data(), mask, count, s.target[i].data(),
             s.gains.data(), s.potR.data(), s.potG.data(), s.potB.data());
  for (size_t i = 0; i < lights.size(); ++i)
    giveOut(s.target[i].data(), s.gains.data(), s.potR.data(), s.potG.data(), s.potB.data(), count,
            lights[i].r, lights[i].g, lights[i].b);
}

}  // namespace swaplight
