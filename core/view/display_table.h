#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/view/baked_view.h"
#include "core/view/view_settings.h"

namespace swaplight {

/// Maps scene-linear rows to 8-bit display codes under the viewer's settings: exposure, view, gamma, channel,
/// false colour. Zebra is drawn later: it depends on the place. A millisecond to make from a baked view.
class DisplayTable {
 public:
  /// Without a view, values are shown as they are: for maps that are data.
  DisplayTable(std::shared_ptr<const BakedView> view, const ViewSettings& settings);

  /// Writes R, G, B, 255 as bytes. Infinity counts as the largest value, NaN as 0.
  void apply(const float* r, const float* g, const float* b, size_t count, uint32_t* rgba) const;

 private:
  std::shared_ptr<const BakedView> m_view;
  float m_exposure = 1;
  ViewChannel m_channel = ViewChannel::Color;
  std::array<std::vector<uint8_t>, 3> m_codes;  ///< by the bits of a half float
  std::vector<uint32_t> m_falseColors;          ///< by the bits of the luminance as a half float
};

}  // namespace swaplight
