#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <string>

#include "core/ocio/display_luminance.h"
#include "core/session/document.h"
#include "core/view/display/display_table.h"

namespace swaplight {

/// The way from a set's pixels to display codes as a frame is exported: without the viewer's exposure, gamma
/// and channels. For what tells about the picture: probe and scopes.
class ViewTable {
 public:
  /// Made again where the configuration, the colour space or the view changed; for other threads, too. Throws
  /// InputError for an unknown view.
  std::shared_ptr<const DisplayTable> table(const std::shared_ptr<const ColorConfig>& config,
                                            const std::string& colorSpace, const DisplayChoice& display);
  /// Of the colour space of the last table().
  [[nodiscard]] const Rgb& luminanceWeights() const { return m_weights; }
  [[nodiscard]] const glm::mat3& xyzFromRgb() const { return m_xyzFromRgb; }
  /// Of the display of the last table().
  [[nodiscard]] const DisplayLuminance& displayLuminance() const { return m_luminance; }

 private:
  std::shared_ptr<const ColorConfig> m_config;
  std::string m_colorSpace;
  DisplayChoice m_display;
  std::shared_ptr<const DisplayTable> m_table;
  Rgb m_weights{0, 1, 0};
  glm::mat3 m_xyzFromRgb{1};
  DisplayLuminance m_luminance;
};

}  // namespace swaplight
