#include "core/relight/relight.h"

#include <array>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/simd.h"

namespace swaplight {
namespace {

constexpr int kRowsABand = 32;

// Pictures that are added up at a time: enough for most sets in one sweep, few enough to stay in registers.
constexpr size_t kTerms = 4;

/// One channel of a picture, and the factor on it.
struct Term {
  ImageView picture;
  float factor;
};

/// What is added up at a time, for one row. Missing terms have the factor 0 and repeat a row that is read
/// anyway.
struct Sweep {
  std::array<const float*, kTerms> rows;
  std::array<float, kTerms> factors;
};

SWAPLIGHT_SIMD void setToSum(float* __restrict out, const Sweep& sweep, ptrdiff_t count) {
  const auto [a, b, c, d] = sweep.rows;
  const auto [fa, fb, fc, fd] = sweep.factors;
  for (ptrdiff_t p = 0; p < count; ++p) out[p] = fa * a[p] + fb * b[p] + fc * c[p] + fd * d[p];
}

SWAPLIGHT_SIMD void addSum(float* __restrict out, const Sweep& sweep, ptrdiff_t count) {
  const auto [a, b, c, d] = sweep.rows;
  const auto [fa, fb, fc, fd] = sweep.factors;
  for (ptrdiff_t p = 0; p < count; ++p) out[p] += fa * a[p] + fb * b[p] + fc * c[p] + fd * d[p];
}

Sweep sweepOf(const std::vector<Term>& terms, size_t first, int channel, int y) {
  Sweep sweep;
  for (size_t i = 0; i < kTerms; ++i) {
    const bool missing = first + i >= terms.size();
    const Term& term = terms[missing ? first : first + i];
    sweep.rows[i] = term.picture.row(channel, y);
    sweep.factors[i] = missing ? 0 : term.factor;
  }
  return sweep;
}

/// The terms that give light in a channel: what is off is not read.
std::vector<Term> termsOf(const SolvedSet& set, std::span<const Rgb> factors, float ambientFactor,
                          int channel) {
  std::vector<Term> terms;
  for (size_t i = 0; i < factors.size(); ++i)
    if (factors[i][channel] != 0) terms.push_back({set.contributions[i].view(), factors[i][channel]});
  if (set.ambient && ambientFactor != 0) terms.push_back({set.ambient->view(), ambientFactor});
  return terms;
}

}  // namespace

void relight(const SolvedSet& set, std::span<const Rgb> factors, float ambientFactor, ImageSpan out) {
  if (factors.size() != set.contributions.size())
    throw InputError("{} light factors for a set of {} lights", factors.size(), set.contributions.size());
  if (out.width != set.width() || out.height != set.height() || out.channels < 3)
    throw InputError("a picture of {} x {} pixels for a set of {} x {}", out.width, out.height, set.width(),
                     set.height());
  for (int channel = 0; channel < 3; ++channel) {
    const std::vector<Term> terms = termsOf(set, factors, ambientFactor, channel);
    parallelRows(out.height, kRowsABand, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        float* row = out.row(channel, y);
        if (terms.empty()) std::fill_n(row, out.width, 0.0f);
        for (size_t first = 0; first < terms.size(); first += kTerms) {
          const Sweep sweep = sweepOf(terms, first, channel, y);
          (first == 0 ? setToSum : addSum)(row, sweep, out.width);
        }
      }
    });
  }
}

Image relight(const SolvedSet& set, std::span<const Rgb> factors, float ambientFactor) {
  ImageSpec spec = ImageSpec::rgb(set.width(), set.height());
  spec.colorSpace = set.colorSpace();
  Image out(std::move(spec));
  relight(set, factors, ambientFactor, out.span());
  return out;
}

}  // namespace swaplight
