#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/intake/shot_folder.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// Colours that are told as "chart:FILE": the light in a photograph of a Macbeth chart.
class ToldCharts {
 public:
  /// Reads the charts that the texts name, each once, see chartColors().
  ToldCharts(const ColorConfig& config, const ShotFolder& folder, const std::string& colorSpace,
             const std::vector<std::string>& texts, const Progress& progress);

  /// The text with every "chart:FILE" as linear r/g/b.
  [[nodiscard]] std::string in(const std::string& text) const;
  [[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }

 private:
  std::map<std::string, std::string> m_colors;
  std::vector<std::string> m_warnings;
};

}  // namespace swaplight
