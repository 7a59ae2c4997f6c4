#include "core/relight/relight.h"

#include <vector>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/relight/weighted_sum.h"

namespace swaplight {
namespace {

constexpr int kRowsABand = 32;

/// One channel of a picture, and the factor on it.
struct Term {
  ImageView picture;
  float factor;
};

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
  SWAPLIGHT_CHECK_EQ(factors.size(), set.contributions.size());
  SWAPLIGHT_CHECK_EQ(out.width, set.width());
  SWAPLIGHT_CHECK_EQ(out.height, set.height());
  SWAPLIGHT_CHECK_LE(3, out.channels);
  for (int channel = 0; channel < 3; ++channel) {
    const std::vector<Term> terms = termsOf(set, factors, ambientFactor, channel);
    parallelRows(out.height, kRowsABand, [&](int begin, int end) {
      std::vector<WeightedRow> rows(terms.size());
      for (int y = begin; y < end; ++y) {
        for (size_t i = 0; i < terms.size(); ++i)
          rows[i] = {terms[i].picture.row(channel, y), terms[i].factor};
        weightedSum(rows, out.width, out.row(channel, y));
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
