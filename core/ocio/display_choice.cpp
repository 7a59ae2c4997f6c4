#include "core/ocio/display_choice.h"

#include <algorithm>

#include "core/ocio/color_config.h"

namespace swaplight {

DisplayChoice DisplayChoice::over(const DisplayChoice& other) const {
  DisplayChoice choice = *this;
  if (display.empty() && view.empty()) choice = {other.display, other.view, look ? look : other.look};
  choice.grade = grade ? grade : other.grade;
  return choice;
}

DisplayChoice displayWithin(const ColorConfig& config, const DisplayChoice& choice) {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return name.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  DisplayChoice within = choice;
  if (choice.look && !config.unknownLook(*choice.look).empty()) within.look.reset();
  DisplayChoice own{"", "", within.look, within.grade};
  if (!has(config.displays(), choice.display)) return own;
  const std::string display = choice.display.empty() ? config.defaultDisplay() : choice.display;
  return has(config.views(display), choice.view) ? within : own;
}

DisplayChoice namedDisplay(const ColorConfig& config, DisplayChoice choice) {
  if (choice.display.empty()) choice.display = config.defaultDisplay();
  if (choice.view.empty()) choice.view = config.defaultView(choice.display);
  return choice;
}

std::string displayWords(const DisplayChoice& choice) {
  std::string words = choice.display;
  if (choice.view != choice.display) words += " \u00b7 " + choice.view;
  if (choice.look) words += " \u00b7 " + (choice.look->empty() ? "no look" : *choice.look);
  return words;
}

std::string lookFromText(const std::string& text) {
  return text == "none" ? "" : text;
}

}  // namespace swaplight
