#include "ui/state/panel_layout.h"

#include <algorithm>
#include <exception>

#include "core/base/json.h"
#include "core/file/json_file.h"
#include "ui/state/enum_names.h"

namespace swaplight {
namespace {

constexpr std::array<const char*, 3> kOfNames = {"frame", "region", "light"};
constexpr std::array<const char*, 4> kUnitNames = {"8bit", "10bit", "percent", "nits"};
constexpr std::array<const char*, 3> kAxisNames = {"codes", "stops", "linear"};

Json jsonFromScopeOptions(const ScopeOptions& options) {
  return Json{{"waveform", options.waveform},
              {"parade", options.parade},
              {"vectorscope", options.vectorscope},
              {"histogram", options.histogram},
              {"chromaticity", options.chromaticity},
              {"of", nameOfEnum(kOfNames, options.of)},
              {"histogram_axis", nameOfEnum(kAxisNames, options.histogramAxis)},
              {"unit", nameOfEnum(kUnitNames, options.unit)},
              {"log_counts", options.logCounts}};
}

ScopeOptions scopeOptionsFromJson(const Json& json) {
  ScopeOptions options;
  options.waveform = json.value("waveform", options.waveform);
  options.parade = json.value("parade", options.parade);
  options.vectorscope = json.value("vectorscope", options.vectorscope);
  options.histogram = json.value("histogram", options.histogram);
  options.chromaticity = json.value("chromaticity", options.chromaticity);
  options.of = enumOfName(kOfNames, json.value("of", ""), options.of);
  options.histogramAxis = enumOfName(kAxisNames, json.value("histogram_axis", ""), options.histogramAxis);
  options.unit = enumOfName(kUnitNames, json.value("unit", ""), options.unit);
  options.logCounts = json.value("log_counts", options.logCounts);
  return options;
}

}  // namespace

PanelLayout readPanelLayout(const std::filesystem::path& file) {
  PanelLayout layout;
  try {
    if (!std::filesystem::exists(file)) return layout;
    const Json json = readJson(file);
    for (const auto& [name, open] : kPanelNames) layout.*open = json.value(name, layout.*open);
    if (json.contains("scope_options")) layout.scopeOptions = scopeOptionsFromJson(json["scope_options"]);
    layout.mixerWidth = std::clamp(json.value("mixer_width", layout.mixerWidth), 300.0F, 900.0F);
    layout.scopesHeight = std::clamp(json.value("scopes_height", layout.scopesHeight), 120.0F, 900.0F);
  } catch (const std::exception&) {
    return {};
  }
  return layout;
}

void writePanelLayout(const PanelLayout& layout, const std::filesystem::path& file) {
  try {
    std::filesystem::create_directories(file.parent_path());
    Json json{{"scope_options", jsonFromScopeOptions(layout.scopeOptions)},
              {"mixer_width", layout.mixerWidth},
              {"scopes_height", layout.scopesHeight}};
    for (const auto& [name, open] : kPanelNames) json[name] = layout.*open;
    writeJson(json, file);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace swaplight
