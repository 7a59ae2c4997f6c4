#pragma once

#include <vector>

#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// Where of one light's shadows nothing can be told: what is hatched.
class UntoldPixels {
 public:
  UntoldPixels() = default;
  /// `labels` are `width` pixels wide; one covers `scale` pixels of the picture, across.
  UntoldPixels(const std::vector<ShadowLabel>& labels, int width, float scale);

  /// At a place in pixels of the picture; false outside it, and on lines of a pixel's width, which are
  /// borders.
  [[nodiscard]] bool at(float x, float y) const;
  /// 0..1, of the picture, borders and all.
  [[nodiscard]] float share() const { return m_share; }

 private:
  std::vector<bool> m_untold;
  int m_width = 0, m_height = 0;
  float m_scale = 1;
  float m_share = 0;
};

}  // namespace swaplight
