#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/marks/mark_word.h"

namespace swaplight {

/// Where a light's marks have the last word, in a visibility of the size `full`. Nowhere without marks.
class SettledPixels {
 public:
  /// `picture`: the size of the picture whose pixels the marks name; `word`: of wordOfMarks(); `shadow`: the
  /// cut made with it (8-bit, 255 in shadow), of the word's size. Beside the cut's borders nothing is
  /// settled: their pixels are found on the larger picture.
  SettledPixels(const ShadowMarks& marks, cv::Size picture, const cv::Mat& word, const cv::Mat& shadow,
                cv::Size full, const ShadowMarkTuning& tuning = {});

  /// Makes the marked pixels of the cut's visibility umbra or lit.
  void pinIn(cv::Mat& divided) const;
  /// Takes a visibility back to the cut's where what was measured since contradicts a mark.
  void obeyIn(cv::Mat& visibility, const cv::Mat& divided) const;
  /// Sets what can be told (8-bit) where marks tell it.
  void tellIn(cv::Mat& told) const;
  /// Makes float picture 0 where a mark says shadow.
  void denyIn(cv::Mat& reached) const;
  [[nodiscard]] std::vector<cv::Point> pixels() const;

 private:
  struct Pin {
    cv::Point at;
    bool lit;
  };
  std::vector<Pin> m_pins;
  cv::Mat m_shadow, m_lit;  // 0..1
};

}  // namespace swaplight
