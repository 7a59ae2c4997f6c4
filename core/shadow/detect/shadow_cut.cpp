#include "core/shadow/detect/shadow_cut.h"

#include <cmath>

#include "core/shadow/numeric/cut_graph.h"
#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr float kNoChoice = 1000;  // cost of a side that a mark's own place cannot have

// What a mark's word adds to the cost of not being lit.
cv::Mat costOfDenying(const cv::Mat& word, const ShadowTuning& tuning) {
  cv::Mat cost = tuning.cut.markCost * word;
  cost.setTo(kNoChoice, word >= tuning.marks.hard);
  cost.setTo(-kNoChoice, word <= -tuning.marks.hard);
  return cost;
}

// Odds that a mark's word has been added to.
LightOdds withWord(const LightOdds& odds, const cv::Mat& word, const ShadowTuning& tuning) {
  if (odds.umbra.empty() || word.empty()) return odds;
  const cv::Mat lit = costOfDenying(word, tuning);
  return {odds.umbra - lit, odds.lit + lit, odds.visible};
}

// The cheapest cut: 255 where a pixel is parted from the light. `lit`: what it costs not to be lit.
cv::Mat leastCut(const cv::Mat& lit, const cv::Mat& apart, float partingCost, float leastParting) {
  const cv::Size size = apart.size();
  CutGraph graph(size.area(), 2 * size.area());
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const int pixel = y * size.width + x;
      graph.setPull(pixel, lit.at<float>(y, x));
      const auto link = [&](int x2, int y2) {
        const float between = .5f * (apart.at<float>(y, x) + apart.at<float>(y2, x2));
        graph.link(pixel, y2 * size.width + x2, partingCost * std::exp(-between) + leastParting);
      };
      if (x > 0) link(x - 1, y);
      if (y > 0) link(x, y - 1);
    }
  graph.solve();
  cv::Mat shadow(size, CV_8U);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      shadow.at<uchar>(y, x) = graph.onSourceSide(y * size.width + x) ? 0 : 255;
  return shadow;
}

}  // namespace

cv::Mat cutShadow(const cv::Mat& level, float threshold, const ShadowSides& sides, const cv::Mat& word,
                  const ShadowTuning& all) {
  const ShadowCutTuning& tuning = all.cut;
  const cv::Size size = sides.apart.size();
  cv::Mat lit(size, CV_32F);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const float above = level.at<float>(y, x) - threshold;
      float& here = lit.at<float>(y, x);
      here = tuning.levelCost * (above - tuning.middle);
      if (above > tuning.surelyLit) here = tuning.sure;
      if (above < -tuning.surelyShadow) here = -tuning.sure;
      here -= tuning.sideCost * sides.toShadow.at<float>(y, x);
    }
  if (!word.empty()) lit += costOfDenying(word, all);
  if (size.area() == 1) return word.empty() ? level < threshold : lit < 0;  // nothing beside it
  return leastCut(lit, sides.apart, tuning.partingCost, tuning.leastParting);
}

cv::Mat evidenceOfLight(const LightOdds& odds) {
  return odds.umbra.empty() ? cv::Mat() : cv::Mat(.5 * (odds.lit - odds.umbra));
}

cv::Mat cutShadow(const LightOdds& odds, const cv::Mat& apart, const ShadowCutTuning& tuning) {
  const cv::Mat lit = evidenceOfLight(odds);
  if (apart.total() == 1) return lit < 0;
  return leastCut(lit, apart, tuning.oddsPartingCost, tuning.leastParting);
}

ShadowDivision divideShadow(const cv::Mat& level, float threshold, const ShadowSides& sides,
                            const LightOdds& unmarked, const cv::Mat& word, const ShadowTuning& all) {
  const ShadowCutTuning& tuning = all.cut;
  ShadowDivision division{
      cutShadow(level, threshold, sides, word, all), cv::Mat::zeros(level.size(), CV_8U), {}};
  if (unmarked.umbra.empty()) return division;
  division.odds = withWord(unmarked, word, all);
  const cv::Mat byOdds = cutShadow(division.odds, sides.apart, tuning);
  cv::Mat contested = division.shadow != byOdds;
  cv::morphologyEx(contested, contested, cv::MORPH_OPEN,
                   disk(std::max(tuning.border * referenceUnit(contested), 1.F)));
  byOdds.copyTo(division.shadow, contested);
  cv::Mat unsure(level.size(), CV_32F, cv::Scalar(tuning.unsure));
  if (!word.empty()) {  // where a person says the same, less has to speak for it
    const cv::Mat agrees = cv::max(word.mul(asFloat(division.odds.umbra < 0) * 2 - 1), 0);
    unsure -= tuning.unsure / all.marks.settled * agrees;
  }
  division.untold = (cv::abs(division.odds.umbra) < unsure) & (division.odds.visible < tuning.seen);
  if (!word.empty()) {
    division.shadow.setTo(255, word <= -all.marks.hard);  // opening may have taken the place for a border's
    division.shadow.setTo(0, word >= all.marks.hard);
    division.untold.setTo(0, cv::abs(word) >= all.marks.settled);
  }
  return division;
}

}  // namespace swaplight
