#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/ocio/color_config.h"
#include "core/ocio/luminance.h"
#include "core/view/display/baked_view.h"
#include "core/view/display/view_settings.h"

namespace swaplight {

/// Maps rows of scene-linear pixels to 8-bit display codes under the viewer's settings: exposure, view,
/// gamma, channel, false colour. Zebra is drawn later: it depends on the place.
///
/// Against the exact processor: one code where the view is a matrix and curves; elsewhere half a code on
/// average, within two but for one pixel in a thousand (very saturated ones; under AgX on Rec.709, where they
/// are nearly black in one channel, two).
class DisplayTable {
 public:
  /// Without a view, values are shown as they are: for maps that are data.
  DisplayTable(std::shared_ptr<const BakedView> view, const ViewSettings& settings,
               const Rgb& luminanceWeights = kRec709Luminance);
  /// For pictures in a colour space of the configuration, which must outlive the table. Bakes the view: about
  /// 40 ms. Throws InputError where the configuration lacks the space, the display, the view or a look.
  DisplayTable(const ColorConfig& config, std::string colorSpace, const ViewSettings& settings);

  /// Other settings. A millisecond, unless they name another display or view.
  void change(const ViewSettings& settings);

  /// Writes a row as R, G, B, 255. Infinity counts as the largest value, NaN as 0. From any thread.
  void apply(const float* r, const float* g, const float* b, int count, uint8_t* rgba) const;

 private:
  const ColorConfig* m_config = nullptr;
  std::string m_colorSpace;
  std::shared_ptr<const BakedView> m_view;
  Rgb m_luminanceWeights;
  ViewSettings m_settings;
  float m_exposure = 1;
  std::array<std::vector<uint8_t>, 3> m_codes;  ///< by the bits of a half float
  std::vector<uint32_t> m_falseColors;          ///< by the bits of the luminance as a half float
};

}  // namespace swaplight
