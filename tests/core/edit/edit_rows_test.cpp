#include "core/edit/apply/edit_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

constexpr int kCount = 77;  // no multiple of anything

/// Random light: r g b of each light, some pixels dark; a mask with ends.
struct Rows {
  std::vector<std::vector<float>> planes;
  std::vector<float> mask = std::vector<float>(kCount);
  explicit Rows(size_t lights) : planes(lights * 3, std::vector<float>(kCount)) {
    std::mt19937 random(static_cast<unsigned>(lights));
    std::uniform_real_distribution<float> unit(0, 1);
    for (std::vector<float>& plane : planes)
      for (size_t p = 0; p < kCount; ++p) plane[p] = p % 9 == 4 ? 0 : unit(random);
    for (size_t p = 0; p < kCount; ++p) mask[p] = p % 4 == 0 ? float(p % 8 == 0) : unit(random);
  }
  [[nodiscard]] size_t lights() const { return planes.size() / 3; }
  RgbRow row(size_t light) {
    return {planes[light * 3].data(), planes[light * 3 + 1].data(), planes[light * 3 + 2].data()};
  }
  [[nodiscard]] double grey(size_t light, size_t p) const {
    return double(planes[light * 3][p]) + planes[light * 3 + 1][p] + planes[light * 3 + 2][p];
  }
  [[nodiscard]] double grey(size_t p) const {
    double sum = 0;
    for (size_t i = 0; i < lights(); ++i) sum += grey(i, p);
    return sum;
  }
};

TEST(EditRows, BetaIsTheLightsShareAtEveryLevel) {
  Rows rows(3);
  std::vector<float> inverseGrey(kCount), beta(kCount);
  for (size_t p = 0; p < kCount; ++p) inverseGrey[p] = rows.grey(p) > 0 ? float(1 / rows.grey(p)) : 0;
  test::atEveryLevel([&] {
    for (size_t i = 0; i < 3; ++i) {
      const RgbRow row = rows.row(i);
      betaOfRow({row.r, row.g, row.b}, inverseGrey.data(), kCount, beta.data());
      for (size_t p = 0; p < kCount; ++p)
        ASSERT_NEAR(beta[p], rows.grey(p) > 0 ? rows.grey(i, p) / rows.grey(p) : 0, 1e-6);
    }
  });
}

TEST(EditRows, AddingMovesBetaByTheMaskAtEveryLevel) {
  const Rows before(2);  // the light, and the picture under all lights
  std::vector<float> target(kCount, .5F), beta(kCount);
  test::atEveryLevel([&] {
    Rows rows = before;
    for (size_t p = 0; p < kCount; ++p)
      beta[p] = rows.grey(1, p) > 0 ? float(rows.grey(0, p) / rows.grey(1, p)) : 0;
    addRow(rows.row(0), {rows.planes[3].data(), rows.planes[4].data(), rows.planes[5].data()}, beta.data(),
           target.data(), rows.mask.data(), kCount);
    for (size_t p = 0; p < kCount; ++p) {
      const double step = double(rows.mask[p]) * (double(target[p]) - beta[p]);
      for (size_t c = 0; c < 3; ++c) {
        const double old = before.planes[c][p];
        const double expected =
            step > 0 ? old + step * rows.planes[3 + c][p] : (beta[p] > 0 ? old * (1 + step / beta[p]) : old);
        ASSERT_NEAR(rows.planes[c][p], expected, 2e-6 * (1 + expected)) << p;
      }
    }
  });
}

TEST(EditRows, SharingKeepsEachChannelsSumAndReachesTheTargetAtEveryLevel) {
  for (const size_t lights : {2, 3, 5, 9}) {
    const Rows before(lights);
    const std::vector<int> chosen = lights > 2 ? std::vector<int>{0, 2} : std::vector<int>{0};
    test::atEveryLevel([&] {
      Rows rows = before;
      ShareScratch scratch(lights, kCount);
      std::vector<RgbRow> pointers;
      for (size_t i = 0; i < lights; ++i) {
        pointers.push_back(rows.row(i));
        for (size_t p = 0; p < kCount; ++p)
          scratch.beta[i][p] = before.grey(p) > 0 ? float(before.grey(i, p) / before.grey(p)) : 0;
      }
      for (const int i : chosen)
        std::fill(scratch.target[size_t(i)].begin(), scratch.target[size_t(i)].end(), .3F);
      shareRow(pointers, chosen, before.mask.data(), kCount, scratch);
      for (size_t p = 0; p < kCount; ++p) {
        for (size_t c = 0; c < 3; ++c) {
          double sum = 0, old = 0;
          for (size_t i = 0; i < lights; ++i)
            sum += rows.planes[i * 3 + c][p], old += before.planes[i * 3 + c][p];
          ASSERT_NEAR(sum, old, 3e-6 * (1 + old)) << lights << " lights, pixel " << p;
        }
        if (before.grey(p) == 0) continue;
        double chosenBefore = 0, chosenAfter = 0;
        for (const int i : chosen) {
          const double was = before.grey(size_t(i), p) / before.grey(p),
                       wanted = was + before.mask[p] * (.3 - was);
          ASSERT_NEAR(rows.grey(size_t(i), p) / before.grey(p), wanted, 1e-5)
              << lights << " lights, pixel " << p;
          chosenBefore += was, chosenAfter += wanted;
        }
        for (size_t i = 0; i < lights; ++i) {
          if (std::find(chosen.begin(), chosen.end(), int(i)) != chosen.end()) continue;
          const double was = before.grey(i, p) / before.grey(p);  // proportions among the others stay
          ASSERT_NEAR(rows.grey(i, p) / before.grey(p), was * (1 - chosenAfter) / (1 - chosenBefore), 1e-5)
              << p;
        }
      }
    });
  }
}

}  // namespace
}  // namespace swaplight
