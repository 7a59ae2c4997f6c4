#include "core/balance/white_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/color/chromaticity.h"
#include "core/lamp/kelvin.h"

namespace swaplight {
namespace {

constexpr double kMostDuv = 0.05;  // beyond, a temperature says nothing (CIE 015)

// CIE 015:2018: the daylights' temperatures are 1.4388 / 1.4380 times their names, after the constant of
// 1967.
constexpr std::array<NamedWhite, 5> kWhites = {{{"A", "incandescent, CIE A, 2856 K", {2856, 0}},
                                                {"D50", "horizon light, print, 5003 K", {5003, 0}},
                                                {"D55", "midday sun, film daylight, 5503 K", {5503, 0}},
                                                {"D60", "cinema (ACES), 6003 K", {6003, 0}},
                                                {"D65", "noon daylight, video, 6504 K", {kD65Kelvin, 0}}}};

std::optional<double> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string upperCase(std::string text) {
  for (char& c : text) c = char(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::span<const NamedWhite> namedWhites() {
  return kWhites;
}

WhitePoint whitePointFromText(const std::string& text) {
  const auto wrong = [&] {
    return InputError(
        "'{}' is no white point: write A, D50, D55, D60, D65 or a temperature from 1000K to 25000K; off the "
        "locus with a Duv from -0.05 to 0.05, as 4300K,duv:+0.003",
        text);
  };
  const std::string upper = upperCase(text);
  const std::string_view whole = upper;
  // std::find: find() of GCC 12's library makes it warn of a memchr that it cannot see to be right.
  const auto comma = size_t(std::find(upper.begin(), upper.end(), ',') - upper.begin());
  const std::string_view base = whole.substr(0, comma);
  std::optional<WhitePoint> white;
  for (const NamedWhite& named : kWhites)
    if (base == named.name) white = named.white;
  if (!white && base.ends_with('K')) {
    const auto kelvin = number(base.substr(0, base.size() - 1));
    if (!kelvin || *kelvin < kLowestKelvin || *kelvin > kHighestKelvin) throw wrong();
    white = WhitePoint{*kelvin, 0};
  }
  if (!white) throw wrong();
  if (comma == upper.size()) return *white;
  const std::string_view rest = whole.substr(comma + 1);
  const auto duv = rest.starts_with("DUV:") ? number(rest.substr(4)) : std::nullopt;
  if (!duv || std::abs(*duv) > kMostDuv) throw wrong();
  white->duv = *duv;
  return *white;
}

std::string textFromWhitePoint(const WhitePoint& white) {
  std::string text = fmt::format("{}K", white.kelvin);
  for (const NamedWhite& named : kWhites)
    if (white.kelvin == named.white.kelvin) text = named.name;
  return white.duv == 0 ? text : fmt::format("{},duv:{:+}", text, white.duv);
}

Rgb colorOfWhite(const WhitePoint& white) {
  if (white == WhitePoint{kD65Kelvin, 0}) return Rgb(1);
  return rec709FromXy(whiteXy(white.kelvin, white.duv));
}

LightColor lightColorOfWhite(const WhitePoint& white) {
  LightColor color;
  if (white == WhitePoint{kD65Kelvin, 0}) return color;
  color.kind = LightColor::Kind::Kelvin;
  color.kelvin = float(white.kelvin);
  color.green = float(white.duv / kFullGreenDuv);
  if (std::abs(color.green) <= 1) return color;
  color = {};  // more than a full gel: as it is
  color.kind = LightColor::Kind::LinearRgb;
  color.value = colorOfWhite(white);
  return color;
}

}  // namespace swaplight
