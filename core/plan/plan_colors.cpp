#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <glm/common.hpp>

#include "core/base/error.h"
#include "core/file/atomic_file.h"
#include "core/lamp/gel.h"
#include "core/lamp/kelvin.h"
#include "core/lamp/lamp.h"
#include "core/plan/plan_search.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

std::vector<std::string> partsOf(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c == ',' || std::isspace(c); }, ' ');
  std::vector<std::string> parts;
  for (size_t begin = 0; (begin = text.find_first_not_of(' ', begin)) != std::string::npos;) {
    const size_t end = std::min(text.find(' ', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return parts;
}

PlanColor colorOfGel(const Gel& gel) {
  Lamp lamp = Lamp::white(kD65Kelvin);
  lamp.through(gel);
  return {gel.id, glm::max(lamp.color(), Rgb(0))};
}

}  // namespace

std::vector<PlanColor> panelColors() {
  std::vector<PlanColor> colors;
  constexpr std::array<int, 3> kLevels{10, 40, 100};
  for (int r : kLevels)
    for (int g : kLevels)
      for (int b : kLevels)
        if (std::max({r, g, b}) == 100)
          colors.push_back({fmt::format("{}/{}/{}%", r, g, b), Rgb(r, g, b) / 100.0F});
  return colors;
}

std::vector<PlanColor> planColorsFromText(const std::string& text) {
  std::vector<PlanColor> colors;
  for (const std::string& part : partsOf(text)) {
    if (part == "panels") {
      const std::vector<PlanColor> panels = panelColors();
      colors.insert(colors.end(), panels.begin(), panels.end());
      continue;
    }
    const bool bare = part.find('/') != std::string::npos && part.find(':') == std::string::npos;
    LightSetting setting;
    try {
      applySetting(setting, bare ? "rgb:" + part : part);
    } catch (const InputError& error) {
      throw InputError("--colors: '{}' is no colour: {}", part, error.what());
    }
    colors.push_back({part, lightFactor(setting)});
  }
  if (colors.empty())
    throw InputError("--colors: names no colour; write for example .9/.2/.1,#2aa55f,panels");
  return colors;
}

std::vector<PlanColor> planGelsFromText(const std::string& text) {
  std::vector<PlanColor> colors;
  if (text == "all") {
    for (const Gel& gel : allGels())
      if (gel.kind == Gel::Kind::Color) colors.push_back(colorOfGel(gel));
  } else if (std::filesystem::path(text).has_extension() || std::filesystem::exists(text)) {
    for (const Gel& gel : gelsFromCsv(readGelTable(text), text)) colors.push_back(colorOfGel(gel));
  } else {
    for (const std::string& id : partsOf(text)) colors.push_back(colorOfGel(findGel(id)));
  }
  if (colors.empty()) throw InputError("--gels: '{}' names no gel; write for example L106,L124,L119", text);
  return colors;
}

}  // namespace swaplight
