#include "ui/view_table.h"

namespace swaplight {

std::shared_ptr<const DisplayTable> ViewTable::table(const std::string& colorSpace,
                                                     const DisplayChoice& chosen) {
  const DisplayChoice display = displayWithin(ColorConfig::current(), chosen);
  if (m_table && colorSpace == m_colorSpace && display == m_display) return m_table;
  const ColorConfig& config = ColorConfig::current();
  ViewSettings settings;
  settings.display = display.display;
  settings.view = display.view;
  m_table = std::make_shared<const DisplayTable>(config, colorSpace, settings);
  m_weights = swaplight::luminanceWeights(config, colorSpace);
  m_xyzFromRgb = xyzFromLinear(config, colorSpace);
  m_colorSpace = colorSpace;
  m_display = display;
  return m_table;
}

}  // namespace swaplight
