#include "ui/pictures/view_table.h"

namespace swaplight {

std::shared_ptr<const DisplayTable> ViewTable::table(const std::shared_ptr<const ColorConfig>& config,
                                                     const std::string& colorSpace,
                                                     const DisplayChoice& chosen) {
  const DisplayChoice display = displayWithin(*config, chosen);
  if (m_table && config == m_config && colorSpace == m_colorSpace && display == m_display) return m_table;
  ViewSettings settings;
  settings.display = display;
  m_table = std::make_shared<const DisplayTable>(*config, colorSpace, settings);
  m_weights = swaplight::luminanceWeights(*config, colorSpace);
  m_xyzFromRgb = xyzFromLinear(*config, colorSpace);
  m_luminance = DisplayLuminance(*config, display);
  m_config = config;
  m_colorSpace = colorSpace;
  m_display = display;
  return m_table;
}

}  // namespace swaplight
