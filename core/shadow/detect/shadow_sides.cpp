#include "core/shadow/detect/shadow_sides.h"

#include <array>
#include <cmath>

#include "core/shadow/evidence/other_lights.h"
#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/odds/umbra_evidence.h"

namespace swaplight {
namespace {

// In reference units (see referenceUnit).
constexpr std::array kSideDistances = {2.f, 3.f, 4.f};  // from an edge: where its sides are marked

// Adds the strength of edges to the pixels on their dark side (down the slope), and takes it from the others.
void addSides(const cv::Mat& strength, const Slopes& slopes, float unit, cv::Mat& sides) {
  for (int y = 0; y < strength.rows; ++y)
    for (int x = 0; x < strength.cols; ++x) {
      const float here = strength.at<float>(y, x);
      const float sx = slopes.x.at<float>(y, x);
      const float sy = slopes.y.at<float>(y, x);
      const float size = std::hypot(sx, sy);
      if (here <= 0 || size <= 0) continue;
      const auto add = [&](float distance, float amount) {
        const int column = x + static_cast<int>(std::lround(sx / size * distance * unit));
        const int row = y + static_cast<int>(std::lround(sy / size * distance * unit));
        if (column >= 0 && row >= 0 && column < sides.cols && row < sides.rows)
          sides.at<float>(row, column) += amount;
      };
      for (const float distance : kSideDistances) {
        add(-distance, here);
        add(distance, -here);
      }
    }
}

// 0..1: where the ratio stops falling, and is not a step.
cv::Mat bendsOf(const cv::Mat& ratio, const Slopes& slopes, const cv::Mat& known, float unit,
                const ShadowSidesTuning& tuning) {
  const Slopes alongX = slopesOf(slopes.x);
  const Slopes alongY = slopesOf(slopes.y);
  cv::Mat spread;
  cv::magnitude(alongX.x - alongY.y, 2 * alongX.y, spread);
  const cv::Mat middle = alongX.x + alongY.y;
  const cv::Mat most = .5 * (middle + spread);  // eigenvalues of the Hessian
  cv::Mat least = cv::max(.5 * (spread - middle), 0);
  cv::dilate(least, least, disk(tuning.stepReach * unit));
  cv::Mat steepest;
  cv::dilate(sizeOf(slopes), steepest, disk(tuning.slopeReach * unit));
  cv::Mat bends;  // a slope that ends within the smoothing is about 1
  cv::divide(cv::max(most - tuning.stepShare * least, 0) * (4 * unit * unit),
             steepest * unit + tuning.flat * ratio + 1e-5f, bends);
  cv::Mat inside;
  cv::erode(known, inside, disk(tuning.rim * unit));
  bends.setTo(0, ~inside);
  return cv::min(bends, 1);
}

}  // namespace

std::vector<cv::Mat> brightParts(const SetEvidence& set, const std::vector<float>& thresholds) {
  std::vector<cv::Mat> bright;
  for (size_t i = 0; i < set.lights.size(); ++i)
    bright.push_back(asFloat(set.lights[i].level > thresholds[i]));
  return bright;
}

ShadowSides shadowSides(const SetEvidence& set, const std::vector<cv::Mat>& bright, size_t light,
                        const ShadowTuning& tuning) {
  const cv::Size full = set.known.size();
  const cv::Size size = sizeWithin(full, kUmbraLongest);

  // The light's ratio to the others, where they tell something.
  const OtherLights others = otherLights(set, bright, light, 1, tuning.others);
  const cv::Mat telling = asFloat(others.known);
  const cv::Mat known = shrunk(telling, size) > .49;
  const cv::Mat weight = asFloat(known);
  const float unit = referenceUnit(weight);
  const auto smooth = [&](const cv::Mat& x) {
    cv::Mat out;
    cv::GaussianBlur(x, out, {}, tuning.sides.smoothing * unit);
    return out;
  };
  cv::Mat ratio = others.ratioOf(greyOf(set.contributions[light]), telling, size);
  ratio = smooth(ratio.mul(weight)) / cv::max(smooth(weight), 1e-3f);
  const Slopes slopes = slopesOf(ratio);
  const cv::Mat bends = bendsOf(ratio, slopes, known, unit, tuning.sides);

  // Steps, and outlines of things.
  const ShadowEvidence& evidence = set.lights[light];
  const float pixels = static_cast<float>(full.width) / static_cast<float>(size.width);
  const cv::Mat steps = shrunk(evidence.edge, size) * pixels;
  cv::Mat outline = meanOver(others.grey, telling, size) + .01f;
  cv::log(outline, outline);
  outline = sizeOf(slopesOf(outline));

  ShadowSides sides;
  sides.toShadow = cv::Mat(size, CV_32F, cv::Scalar(0));
  cv::Mat clear = bends.clone();
  clear.setTo(0, bends < tuning.sides.leastBend);
  addSides(clear, slopes, unit, sides.toShadow);
  const cv::Mat clearSteps = asFloat(steps >= tuning.sides.leastStep) * tuning.sides.stepStrength;
  addSides(clearSteps, slopesOf(smooth(shrunk(evidence.level, size))), unit, sides.toShadow);
  sides.own =
      bends / tuning.sides.bendApart + cv::min(steps, tuning.sides.mostApart) / tuning.sides.stepApart;
  sides.apart = sides.own + outline / tuning.sides.outlineApart;
  return sides;
}

}  // namespace swaplight
