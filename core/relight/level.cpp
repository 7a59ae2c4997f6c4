#include "core/relight/level.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace swaplight {
namespace {

constexpr std::string_view kTimesSign = "\u00d7";
constexpr const char* kLevelGrammar = "50%, @50, full, out, x2 or -1st";

/// Without spaces and in lower case; the sign of multiplication as an x.
std::string plain(std::string_view text) {
  std::string said;
  while (!text.empty()) {
    const bool times = text.starts_with(kTimesSign);
    const auto c = static_cast<unsigned char>(text.front());
    if (!std::isspace(c)) said += times ? 'x' : static_cast<char>(std::tolower(c));
    text.remove_prefix(times ? kTimesSign.size() : 1);
  }
  return said;
}

bool takeEnd(std::string_view& text, std::string_view end) {
  if (!text.ends_with(end)) return false;
  text.remove_suffix(end.size());
  return true;
}

bool takeBeginning(std::string_view& text, std::string_view beginning) {
  if (!text.starts_with(beginning)) return false;
  text.remove_prefix(beginning.size());
  return true;
}

/// The unit that stands beside the number, which is left.
std::optional<LevelUnit> takeUnit(std::string_view& text) {
  if (takeBeginning(text, "@")) {
    takeEnd(text, "%");
    return LevelUnit::Percent;
  }
  if (takeEnd(text, "%")) return LevelUnit::Percent;
  if (takeBeginning(text, "x") || takeEnd(text, "x")) return LevelUnit::Multiplier;
  if (takeEnd(text, "stops") || takeEnd(text, "stop") || takeEnd(text, "st")) return LevelUnit::Stops;
  return std::nullopt;
}

double factorOf(LevelUnit unit, double number) {
  switch (unit) {
    case LevelUnit::Stops:
      return std::exp2(number);
    case LevelUnit::Percent:
      return number / 100;
    case LevelUnit::Multiplier:
      break;
  }
  return number;
}

}  // namespace

std::optional<double> levelFromText(std::string_view text, std::optional<LevelUnit> bare) {
  const std::string said = plain(text);
  if (said == "full" || said == "@full") return 1;
  if (said == "out" || said == "@out") return 0;
  std::string_view rest = said;
  const std::optional<LevelUnit> written = takeUnit(rest);
  const std::optional<LevelUnit> unit = written ? written : bare;
  const std::optional<float> number = numberFromText(rest);
  if (!unit || !number) return std::nullopt;
  const double factor = factorOf(*unit, static_cast<double>(*number));
  const bool none = factor == 0 && *unit != LevelUnit::Stops;
  if (!none && !(factor >= std::exp2(-double(kMostStops)) && factor <= std::exp2(double(kMostStops))))
    throw InputError(
        "'{}' is no level of a light: write 0 or more, from {:g} stops below the captured level to {:g} "
        "above",
        text, kMostStops, kMostStops);
  return factor;
}

double wantedLevel(std::string_view text, LevelUnit bare) {
  if (const std::optional<double> level = levelFromText(text, bare)) return *level;
  throw InputError("'{}' is no level: write {}", text, kLevelGrammar);
}

double levelOf(const LightSetting& setting) {
  return std::exp2(static_cast<double>(setting.stops)) * static_cast<double>(setting.multiplier);
}

void setLevel(LightSetting& setting, double level) {
  setting.stops = level > 0 ? static_cast<float>(std::log2(level)) : 0;
  setting.multiplier = level > 0 ? 1 : 0;
}

Rig withLevel(Rig rig, std::span<const size_t> lights, double level) {
  const auto named = [&](size_t i) { return std::find(lights.begin(), lights.end(), i) != lights.end(); };
  const auto leader =
      std::find_if(lights.begin(), lights.end(), [&](size_t i) { return rig.lights.at(i).ratioLock; });
  const double before = leader == lights.end() ? 0 : levelOf(rig.lights.at(*leader));
  for (size_t i = 0; i < rig.lights.size(); ++i) {
    LightSetting& light = rig.lights[i];
    if (named(i))
      setLevel(light, level);
    else if (light.ratioLock && before > 0 && level > 0)
      light.stops =
          std::clamp(light.stops + static_cast<float>(std::log2(level / before)), -kMostStops, kMostStops);
  }
  return rig;
}

}  // namespace swaplight
