#include "core/shadow/marks/settled_pixels.h"

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

/// Where the word is strong enough and the cut agrees, inside its borders, at the full size.
cv::Mat settled(const cv::Mat& strength, const cv::Mat& agrees, cv::Size full,
                const ShadowMarkTuning& tuning) {
  cv::Mat holds = clampedToOne((strength - tuning.settled) / tuning.settledRamp).mul(asFloat(agrees));
  cv::erode(holds, holds, {}, {-1, -1}, 1, cv::BORDER_REPLICATE);
  return grown(holds, full);
}

}  // namespace

SettledPixels::SettledPixels(const ShadowMarks& marks, cv::Size picture, const cv::Mat& word,
                             const cv::Mat& shadow, cv::Size full, const ShadowMarkTuning& tuning) {
  if (marks.empty()) return;
  for (const ShadowMark& mark : marks)
    m_pins.push_back({markedPixel(mark, picture, full), mark.is == ShadowMark::Kind::Lit});
  m_shadow = settled(-word, shadow, full, tuning);
  m_lit = settled(word, ~shadow, full, tuning);
}

void SettledPixels::pinIn(cv::Mat& divided) const {
  for (const Pin& pin : m_pins) divided.at<float>(pin.at) = pin.lit ? 1.F : 0.F;
}

void SettledPixels::obeyIn(cv::Mat& visibility, const cv::Mat& divided) const {
  if (m_pins.empty()) return;
  visibility += m_shadow.mul(cv::min(visibility, divided) - visibility);
  visibility += m_lit.mul(cv::max(visibility, divided) - visibility);
  pinIn(visibility);
}

void SettledPixels::tellIn(cv::Mat& told) const {
  if (m_pins.empty()) return;
  told.setTo(255, cv::max(m_shadow, m_lit) > .5);
  for (const Pin& pin : m_pins) told.at<uchar>(pin.at) = 255;
}

void SettledPixels::denyIn(cv::Mat& reached) const {
  if (m_pins.empty()) return;
  cv::min(reached, 1 - m_shadow, reached);
}

std::vector<cv::Point> SettledPixels::pixels() const {
  std::vector<cv::Point> all;
  all.reserve(m_pins.size());
  for (const Pin& pin : m_pins) all.push_back(pin.at);
  return all;
}

}  // namespace swaplight
