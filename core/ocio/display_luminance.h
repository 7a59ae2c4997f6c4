#pragma once

#include <vector>

#include "core/ocio/color_config.h"

namespace swaplight {

/// How bright a display shows a neutral code value, as the configuration's transform from CIE XYZ to the
/// display says, in which 1 stands for 100 cd/m2 (OpenColorIO's convention for display-referred spaces).
class DisplayLuminance {
 public:
  /// Of no display: not known.
  DisplayLuminance() = default;
  /// Not known where the view's codes are no display's (a log view), where its transform has no inverse, and
  /// where there is no such view.
  DisplayLuminance(const ColorConfig& config, const DisplayChoice& choice);

  [[nodiscard]] bool known() const { return !m_nits.empty(); }
  /// cd/m2 of a code 0..1; codes beyond count as the ends. To be called where it is known, as code().
  [[nodiscard]] float nits(float code) const;
  /// The code 0..1 that shows so many cd/m2; 1 where none is so bright.
  [[nodiscard]] float code(float nits) const;

 private:
  std::vector<float> m_nits;  ///< of codes in equal steps, never falling
};

}  // namespace swaplight
