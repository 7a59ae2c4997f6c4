#include "core/shadow/detect/enlarged_shadows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/parallel.h"
#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr int kRadius = 2;             // of the window, pixels of the smaller set
constexpr double kVariance = 1e-3;     // of q: below it a window is even
constexpr float kEven = .02F;          // of the other lights' mean in a window: less is no print
constexpr float kLeastOthers = .005F;  // of the 99th percentile: darker is alike, too

cv::Mat windowMean(const cv::Mat& x) {
  cv::Mat mean;
  cv::boxFilter(x, mean, CV_32F, {2 * kRadius + 1, 2 * kRadius + 1}, {-1, -1}, true, cv::BORDER_REFLECT);
  return mean;
}

/// The sum of all contributions, three planes.
std::array<cv::Mat, 3> sumOf(const SolvedSet& set) {
  std::array<cv::Mat, 3> sum;
  for (int c = 0; c < 3; ++c) {
    sum[size_t(c)] = planeOf(set.contributions.front(), c).clone();
    for (size_t i = 1; i < set.contributions.size(); ++i) sum[size_t(c)] += planeOf(set.contributions[i], c);
  }
  return sum;
}

/// y as a linear function of x in a window about each pixel: He and Sun's means of slope and offset.
struct Linear {
  cv::Mat slope, offset;
};

Linear linearIn(const cv::Mat& x, const cv::Mat& y, const cv::Mat& leastVariance) {
  const cv::Mat meanX = windowMean(x), meanY = windowMean(y);
  const cv::Mat slope = (windowMean(x.mul(y)) - meanX.mul(meanY)) /
                        (cv::max(windowMean(x.mul(x)) - meanX.mul(meanX), 0) + leastVariance);
  return {windowMean(slope), windowMean(meanY - slope.mul(meanX))};
}

/// What one light's shadows are made of at full size: smooth maps of the smaller one. `direct` and the whole
/// light are linear in the other lights' sum (exactly proportional on a print; where another light's shadow
/// ends they have no part in it), the visibility in what arrives of the whole.
enum Map {
  kSlope,
  kOffset,
  kLeast,
  kMost,
  kWholeSlope,
  kWholeOffset,
  kDirectSlope,
  kDirectOffset = kDirectSlope + 3,
  kMaps = kDirectOffset + 3
};
using Maps = std::array<cv::Mat, kMaps>;

Maps mapsOf(const SolvedSet& small, const std::array<cv::Mat, 3>& sum, const LightShadows& found,
            size_t light, float least) {
  Maps maps;
  const auto put = [&](size_t slope, size_t offset, const Linear& linear) {
    maps[slope] = linear.slope;
    maps[offset] = linear.offset;
  };
  const auto evenBelow = [&](const cv::Mat& x) {
    const cv::Mat floor = kEven * windowMean(x) + least;
    return cv::Mat(floor.mul(floor));
  };
  const Image& own = small.contributions[light];
  const cv::Mat visibility = planeOf(found.visibility, 0);
  cv::Mat whole(visibility.size(), CV_32F, cv::Scalar(0)), grey = whole.clone(), others = whole.clone();
  for (int c = 0; c < 3; ++c) {
    const cv::Mat direct = planeOf(found.direct, c);
    const cv::Mat other = cv::max(sum[size_t(c)] - planeOf(own, c), 0);
    put(size_t(kDirectSlope + c), size_t(kDirectOffset + c), linearIn(other, direct, evenBelow(other)));
    grey += planeOf(own, c) / 3;
    whole += direct.mul(1 - visibility) / 3;
    others += other / 3;
  }
  whole += grey;
  put(kWholeSlope, kWholeOffset, linearIn(others, whole, evenBelow(others)));
  const cv::Mat q = grey / cv::max(whole, 1e-9);
  put(kSlope, kOffset, linearIn(q, visibility, cv::Mat(q.size(), CV_32F, cv::Scalar(kVariance))));
  cv::erode(visibility, maps[kLeast], {});
  cv::dilate(visibility, maps[kMost], {});
  return maps;
}

/// One row of full size out of the maps, by linear interpolation.
class MapRow {
 public:
  MapRow(const Maps& maps, cv::Size full) : m_maps(maps), m_full(full), m_rows(size_t(maps[0].cols)) {}

  void goTo(int y) {
    const cv::Size small = m_maps[0].size();
    const auto [first, second, share] = between(y, m_full.height, small.height);
    for (size_t m = 0; m < kMaps; ++m) {
      const auto* above = m_maps[m].ptr<float>(first);
      const auto* below = m_maps[m].ptr<float>(second);
      for (int x = 0; x < small.width; ++x) m_rows[size_t(x)][m] = above[x] + share * (below[x] - above[x]);
    }
  }
  [[nodiscard]] std::array<float, kMaps> at(int x) const {
    const auto [first, second, share] = between(x, m_full.width, m_maps[0].cols);
    const auto& left = m_rows[size_t(first)];
    const auto& right = m_rows[size_t(second)];
    std::array<float, kMaps> value;
    for (size_t m = 0; m < kMaps; ++m) value[m] = left[m] + share * (right[m] - left[m]);
    return value;
  }

 private:
  struct Between {
    int first, second;
    float share;
  };
  static Between between(int at, int full, int small) {
    const float place =
        std::clamp((float(at) + .5F) * float(small) / float(full) - .5F, 0.F, float(small - 1));
    const int first = int(place);
    return {first, std::min(first + 1, small - 1), place - float(first)};
  }

  const Maps& m_maps;
  cv::Size m_full;
  std::vector<std::array<float, kMaps>> m_rows;
};

/// The pixel of the smaller set that covers most of one.
int placeIn(int at, int full, int small) {
  return std::min(int((int64_t(at) * 2 + 1) * small / (int64_t(full) * 2)), small - 1);
}

ShadowLabel labelOf(float visibility, ShadowLabel found, const ShadowRegionsTuning& tuning) {
  if (found == ShadowLabel::Unknown) return found;
  return visibility < tuning.umbra ? ShadowLabel::Umbra
         : visibility < tuning.lit ? ShadowLabel::Penumbra
                                   : ShadowLabel::Lit;
}

LightShadows enlarged(const SolvedSet& set, const std::array<cv::Mat, 3>& sum, const LightShadows& found,
                      const Maps& maps, size_t light, const ShadowTuning& tuning) {
  const int width = set.width(), height = set.height();
  const int smallWidth = found.visibility.width(), smallHeight = found.visibility.height();
  LightShadows large;
  large.threshold = found.threshold;
  large.visibility = Image(ImageSpec{width, height, {"Y"}, found.visibility.spec().colorSpace});
  large.direct = Image(ImageSpec{width, height, {"R", "G", "B"}, found.direct.spec().colorSpace});
  large.labels.resize(size_t(width) * size_t(height));
  const Image& own = set.contributions[light];
  parallelRows(height, 64, [&](int begin, int end) {
    MapRow row(maps, {width, height});
    for (int y = begin; y < end; ++y) {
      row.goTo(y);
      const ShadowLabel* labels = &found.labels[size_t(placeIn(y, height, smallHeight)) * size_t(smallWidth)];
      for (int x = 0; x < width; ++x) {
        const size_t p = size_t(y) * size_t(width) + size_t(x);
        const std::array<float, kMaps> map = row.at(x);
        float grey = 0, othersGrey = 0, direct[3];
        for (int c = 0; c < 3; ++c) {
          const float mine = own.plane(c)[p];
          const float others = std::max(sum[size_t(c)].ptr<float>(y)[x] - mine, 0.F);
          direct[c] = std::max(map[size_t(kDirectSlope + c)] * others + map[size_t(kDirectOffset + c)], 0.F);
          grey += mine / 3;
          othersGrey += others / 3;
        }
        const float whole = map[kWholeSlope] * othersGrey + map[kWholeOffset];
        const float q = std::min(grey / std::max(whole, 1e-9F), 2.F);
        const float v = std::clamp(map[kSlope] * q + map[kOffset], map[kLeast], map[kMost]);
        large.visibility.plane(0)[p] = v;
        large.labels[p] = labelOf(v, labels[placeIn(x, width, smallWidth)], tuning.regions);
        // As in fillShadow(): where much of the light arrives, the contribution itself says what it is.
        const float lit = std::clamp(
            (v - tuning.fill.barelySeen) / (tuning.fill.fullySeen - tuning.fill.barelySeen), 0.F, 1.F);
        for (int c = 0; c < 3; ++c)
          large.direct.plane(c)[p] = std::max(direct[c] + lit * (own.plane(c)[p] - v * direct[c]), 0.F);
      }
    }
  });
  return large;
}

}  // namespace

std::vector<LightShadows> enlargedShadows(const SolvedSet& set, const SolvedSet& small,
                                          std::vector<LightShadows> found, const Progress& progress,
                                          const ShadowTuning& tuning) {
  const std::array<cv::Mat, 3> sum = sumOf(set), smallSum = sumOf(small);
  const cv::Mat grey = (smallSum[0] + smallSum[1] + smallSum[2]) / 3;
  const float least = std::max(kLeastOthers * percentile(grey, .99), 1e-12F);
  std::vector<LightShadows> all;
  for (size_t i = 0; i < found.size(); ++i) {
    progress.update(float(i) / float(found.size()), "shadows at full size");
    const Maps maps = mapsOf(small, smallSum, found[i], i, least);
    all.push_back(enlarged(set, sum, found[i], maps, i, tuning));
    found[i] = {};
  }
  return all;
}

}  // namespace swaplight
