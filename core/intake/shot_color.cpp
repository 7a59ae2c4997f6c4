#include "core/intake/shot_color.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "core/base/error.h"
#include "core/lamp/gel.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

std::string trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// A maker's letter and a number.
bool looksLikeGel(const std::string& text) {
  return text.size() > 1 && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
         std::all_of(text.begin() + 1, text.end(),
                     [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

}  // namespace

ShotColor shotColorFromText(const std::string& written) {
  const std::string text = trimmed(written);
  if (text.empty() || text == "unknown" || text == "?") return {"unknown", std::nullopt};
  if (isColorName(text)) return {text, std::nullopt};
  std::string setting = text;
  if (looksLikeGel(text)) setting = "gel:" + findGel(text).id;
  if (text.find('/') != std::string::npos && text.find(':') == std::string::npos) setting = "rgb:" + text;
  LightSetting light;
  try {
    applySetting(light, setting);
  } catch (const InputError& error) {
    throw InputError(
        "'{}' is no colour of a light: write a gel's number, linear r/g/b, #rrggbb, 3200K, off, unknown, or "
        "?a for one that is unknown and the same elsewhere ({})",
        text, error.what());
  }
  return {text, lightFactor(light)};
}

std::vector<ShotColor> shotColorsFromText(const std::string& text) {
  std::vector<ShotColor> colors;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) colors.push_back(shotColorFromText(part));
  return colors;
}

std::vector<ShotColor> namedUnknowns(std::vector<ShotColor> ring) {
  const auto taken = [&](const std::string& name) {
    return std::any_of(ring.begin(), ring.end(), [&](const ShotColor& c) { return c.text == name; });
  };
  for (ShotColor& color : ring) {
    if (color.color || !color.name().empty()) continue;
    std::string name = "?a";
    while (name[1] < 'z' && taken(name)) ++name[1];
    color.text = name;
  }
  return ring;
}

ShotColor shotColorFromRgb(const Rgb& color) {
  return {fmt::format("{:.4g}/{:.4g}/{:.4g}", color.r, color.g, color.b), color};
}

ShotColor colorOfCard(const Image& shot, int x, int y, int side) {
  if (x < 0 || y < 0 || x >= shot.width() || y >= shot.height())
    throw InputError("the card at {},{} lies outside of the picture of {} x {} pixels", x, y, shot.width(),
                     shot.height());
  const int left = std::clamp(x - side / 2, 0, std::max(0, shot.width() - side));
  const int top = std::clamp(y - side / 2, 0, std::max(0, shot.height() - side));
  Rgb sum(0);
  int count = 0;
  for (int row = top; row < std::min(top + side, shot.height()); ++row)
    for (int column = left; column < std::min(left + side, shot.width()); ++column) {
      const Rgb pixel(shot.view().at(0, column, row), shot.view().at(1, column, row),
                      shot.view().at(2, column, row));
      if (!std::isfinite(pixel.r + pixel.g + pixel.b)) continue;
      sum += pixel;
      ++count;
    }
  const Rgb mean = count > 0 ? sum / static_cast<float>(count) : Rgb(0);
  if (!(std::max({mean.r, mean.g, mean.b}) > 1e-4F))
    throw InputError("the card at {},{} is black: nothing can be read off it", x, y);
  return shotColorFromRgb({std::max(mean.r, 0.0F), std::max(mean.g, 0.0F), std::max(mean.b, 0.0F)});
}

}  // namespace swaplight
