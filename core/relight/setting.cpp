#include "core/relight/setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/base/number_text.h"
#include "core/color/srgb.h"
#include "core/lamp/gel.h"
#include "core/lamp/kelvin.h"
#include "core/relight/level.h"

namespace swaplight {
namespace {

constexpr float kMostFactor = 1e9F;

/// A number in [low, high], or an error that quotes the part.
float numberIn(std::string_view text, float low, float high, std::string_view part, const char* right) {
  const std::optional<float> value = numberFromText(text);
  if (!value || *value < low || *value > high) throw InputError("'{}' is not right: write {}", part, right);
  return *value;
}

Rgb threeNumbers(std::string_view text, const Rgb& high, std::string_view part, const char* right) {
  Rgb values;
  for (int c = 0; c < 3; ++c) {
    const size_t slash = c < 2 ? text.find('/') : text.size();
    if (slash == std::string_view::npos) throw InputError("'{}' is not right: write {}", part, right);
    values[c] = numberIn(text.substr(0, slash), 0, high[c], part, right);
    text.remove_prefix(std::min(slash + 1, text.size()));
  }
  return values;
}

Rgb hexColor(std::string_view part) {
  Rgb value;
  for (size_t c = 0; c < 3; ++c) {
    const std::string_view digits = part.size() == 7 ? part.substr(1 + 2 * c, 2) : "";
    int code = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size() || digits[0] == '-')
      throw InputError("'{}' is not right: write # and six hexadecimal digits, as #4060ff", part);
    value[static_cast<int>(c)] = static_cast<float>(code) / 255;
  }
  return value;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

/// Gives the light a colour of its own; gel and green stay over it.
void setColor(LightSetting& setting, LightColor::Kind kind, const Rgb& value) {
  setting.color.kind = kind;
  setting.color.value = value;
  setting.color.kelvin = LightColor().kelvin;
}

/// The whole level, and not only its stops or its multiplier.
bool saysLevel(std::string_view text) {
  return text.starts_with('@') || text.ends_with('%') || text == "full" || text == "out";
}

/// A gel's number alone, as gaffers say it.
bool isGel(const std::string& lower) {
  const std::vector<Gel>& gels = allGels();
  return std::any_of(gels.begin(), gels.end(), [&](const Gel& gel) { return lowerCase(gel.id) == lower; });
}

void applyPart(LightSetting& setting, std::string_view part) {
  using Kind = LightColor::Kind;
  const std::string lower = lowerCase(part);
  const std::string_view text = lower;
  const auto after = [&](size_t count) { return text.substr(count); };
  const auto before = [&](size_t count) { return text.substr(0, text.size() - count); };

  if (text == "on" || text == "off") {
    setting.on = text == "on";
  } else if (text == "white") {
    setColor(setting, Kind::White, Rgb(1));
  } else if (text.starts_with('#')) {
    setColor(setting, Kind::Hex, hexColor(part));
  } else if (text.starts_with("rgb:")) {
    setColor(setting, Kind::LinearRgb,
             threeNumbers(after(4), Rgb(kMostFactor), part,
                          "rgb: and three linear values from 0 to 1e9, as rgb:0.9/0.5/0.2"));
  } else if (text.starts_with("hsv:")) {
    Rgb hsv = threeNumbers(after(4), {360, 1, 1}, part,
                           "hsv: and hue (0..1, or degrees up to 360), saturation and value (0..1), as "
                           "hsv:210/0.8/1");
    if (hsv.x > 1) hsv.x /= 360;
    setColor(setting, Kind::Hsv, hsv);
  } else if (text.starts_with("green:")) {
    setting.color.green =
        numberIn(after(6), -1, 1, part, "green: and a number from -1 to +1, as green:+0.25");
  } else if (text == "gel:none") {
    setting.color.gel.clear();
  } else if (text.starts_with("gel:")) {
    setting.color.gel = findGel(std::string(part.substr(4))).id;
  } else if (text.ends_with("st") && numberFromText(before(2))) {
    setting.stops =
        numberIn(before(2), -kMostStops, kMostStops, part, "stops from -30st to +30st, as +1.5st");
  } else if (text.ends_with('k') && numberFromText(before(1))) {
    setColor(setting, Kind::Kelvin, Rgb(1));
    setting.color.kelvin = numberIn(before(1), kLowestKelvin, kHighestKelvin, part,
                                    "a temperature from 1000K to 25000K, as 3200K");
  } else if (text.starts_with('x') && numberFromText(after(1))) {
    setting.multiplier = numberIn(after(1), 0, kMostFactor, part, "a factor from 0 to 1e9, as x1.7");
  } else if (const std::optional<double> level = saysLevel(text) ? levelFromText(text) : std::nullopt) {
    setLevel(setting, *level);
  } else if (isGel(lower)) {
    setting.color.gel = findGel(std::string(part)).id;
  } else {
    throw InputError("'{}' is no light setting; known are {}", part, kSettingGrammar);
  }
}

std::string threeText(const char* name, const Rgb& v) {
  return fmt::format("{}:{}/{}/{}", name, v.x, v.y, v.z);
}

/// #rrggbb, or the exact linear colour where that would be rounded.
std::string hexText(const Rgb& encoded) {
  std::string hex = fmt::format("#{:02x}{:02x}{:02x}", std::lround(255 * encoded.x),
                                std::lround(255 * encoded.y), std::lround(255 * encoded.z));
  if (hex.size() == 7 && hexColor(hex) == encoded) return hex;
  return threeText("rgb", linearFromSrgb(encoded));
}

std::string join(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, ","));
}

}  // namespace

void applySetting(LightSetting& setting, const std::string& text) {
  LightSetting result = setting;
  std::string_view rest = text;
  while (true) {
    const size_t comma = rest.find(',');
    applyPart(result, trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  setting = result;
}

std::string colorText(const LightColor& color) {
  std::vector<std::string> parts;
  switch (color.kind) {
    case LightColor::Kind::White:
      break;
    case LightColor::Kind::Hex:
      parts.push_back(hexText(color.value));
      break;
    case LightColor::Kind::LinearRgb:
      parts.push_back(threeText("rgb", color.value));
      break;
    case LightColor::Kind::Hsv:
      parts.push_back(threeText("hsv", color.value));
      break;
    case LightColor::Kind::Kelvin:
      parts.push_back(fmt::format("{}K", color.kelvin));
      break;
  }
  if (!color.gel.empty()) parts.push_back("gel:" + color.gel);
  if (color.green != 0) parts.push_back(fmt::format("green:{:+}", color.green));
  return parts.empty() ? "white" : join(parts);
}

std::string settingText(const LightSetting& setting) {
  std::vector<std::string> parts;
  if (!setting.on) parts.emplace_back("off");
  if (setting.color != LightColor()) parts.push_back(colorText(setting.color));
  if (setting.stops != 0) parts.push_back(fmt::format("{:+}st", setting.stops));
  if (setting.multiplier != 1) parts.push_back(fmt::format("x{}", setting.multiplier));
  return parts.empty() ? "on" : join(parts);
}

}  // namespace swaplight
