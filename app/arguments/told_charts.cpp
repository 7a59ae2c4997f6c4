#include "app/arguments/told_charts.h"

#include <algorithm>
#include <string_view>
#include <tuple>

#include "core/chart/chart_colors.h"

namespace swaplight {
namespace {

constexpr std::string_view kChart = "chart:";

/// Where the name of a chart's file stands in a text, from `from` on: its first letter and the one behind it.
std::pair<size_t, size_t> nameIn(const std::string& text, size_t from) {
  const size_t at = text.find(kChart, from);
  if (at == std::string::npos) return {at, at};
  return {at + kChart.size(), std::min(text.find(',', at), text.size())};
}

std::vector<std::string> namesIn(const std::vector<std::string>& texts) {
  std::vector<std::string> names;
  for (const std::string& text : texts)
    for (auto [begin, end] = nameIn(text, 0); begin != std::string::npos;
         std::tie(begin, end) = nameIn(text, end)) {
      const std::string name = text.substr(begin, end - begin);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  return names;
}

}  // namespace

ToldCharts::ToldCharts(const ColorConfig& config, const ShotFolder& folder, const std::string& colorSpace,
                       const std::vector<std::string>& texts, const Progress& progress) {
  for (const ChartColor& chart : chartColors(config, folder, colorSpace, namesIn(texts), progress)) {
    m_colors[chart.file] = chart.color.text;
    for (const std::string& warning : chart.warnings) m_warnings.push_back(chart.file + ": " + warning);
  }
}

std::string ToldCharts::in(const std::string& text) const {
  std::string told;
  size_t done = 0;
  for (auto [begin, end] = nameIn(text, 0); begin != std::string::npos;
       std::tie(begin, end) = nameIn(text, end)) {
    told += text.substr(done, begin - kChart.size() - done) + m_colors.at(text.substr(begin, end - begin));
    done = end;
  }
  return told + text.substr(done);
}

}  // namespace swaplight
