#include "core/shadow/evidence/fading_light.h"

#include <algorithm>

#include "core/shadow/evidence/guided_mean.h"
#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/numeric/smooth_fill.h"

namespace swaplight {
namespace {

constexpr int kLongest = 320;  // pixels: means over wide windows need no more

}  // namespace

FadingLight fadingLight(const cv::Mat& ratio, const cv::Mat& fixed, const cv::Mat& guide,
                        const ShadowTuning& tuning) {
  const cv::Size full = ratio.size();
  const cv::Size size = sizeDivided(full, double(std::max(full.width, full.height)) / kLongest);
  const cv::Mat share = asFloat(fixed);
  const cv::Mat known = shrunk(share, size) > 0;
  const cv::Mat where = asFloat(known), edges = shrunk(guide, size), level = meanOver(ratio, share, size);
  const double near = std::max(2., tuning.fading.near * referenceUnit(where));

  const cv::Mat around =
      cv::max(guidedMean(level, where, edges, tuning.fading.wide * near, tuning.others), 1e-6);
  const cv::Mat beside = guidedMean(level, where, edges, near, tuning.others);
  const cv::Mat cast = clampedToOne((beside / around - tuning.fading.gone) / tuning.fading.goneRamp);
  const cv::Mat continued = fillSmoothly(cast, known, edges, tuning.others.ratioEdge);
  const cv::Mat beyond = clampedToOne((continued - tuning.fading.castFrom) / tuning.fading.castRamp);
  // Means where nothing is known do not count: beside them are pixels that are.
  const cv::Mat aroundKnown = grown(around.mul(where), full) / cv::max(grown(where, full), 1e-6);
  return {cv::max(aroundKnown, 1e-6), grown(continued, full), grown(beyond, full)};
}

}  // namespace swaplight
