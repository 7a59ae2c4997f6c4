#include "core/filter/filter_value.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

struct TypeName {
  FilterInputType type;
  const char* name;
  const char* expected;
};

constexpr std::array<TypeName, 12> kTypes = {{
    {FilterInputType::Event, "event", "true or false"},
    {FilterInputType::Bool, "bool", "true or false"},
    {FilterInputType::Choice, "long", "a whole number"},
    {FilterInputType::Float, "float", "a number"},
    {FilterInputType::Point2D, "point2D", "two numbers"},
    {FilterInputType::Color, "color", "three or four numbers (red, green, blue, alpha)"},
    {FilterInputType::Image, "image", "the name of a picture's file"},
    {FilterInputType::Audio, "audio", "sound"},
    {FilterInputType::AudioSpectrum, "audioFFT", "sound"},
    {FilterInputType::Vector, "vector", "two to four numbers"},
    {FilterInputType::Matrix, "matrix", "two to four rows of as many numbers"},
    {FilterInputType::Curve, "curve", "2 to 16 points [x, y], x ascending from 0 to 1"},
}};

constexpr size_t kIsfTypes = 9;

std::optional<FilterInputType> typeAmong(std::span<const TypeName> rows, const std::string& name) {
  for (const TypeName& row : rows)
    if (row.name == name) return row.type;
  return {};
}

const TypeName& rowOf(FilterInputType type) {
  return kTypes[static_cast<size_t>(type)];
}

[[noreturn]] void fail(const std::string& where, const std::string& found, FilterInputType type) {
  throw InputError("{}: is {}, expected {}", where, found, rowOf(type).expected);
}

std::optional<float> finite(const Json& json) {
  if (!json.is_number()) return {};
  const auto value = static_cast<float>(json.get<double>());
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Numbers parted by ':' or '/'; empty where one of them is none.
std::vector<float> numbersOf(const std::string& text) {
  std::vector<float> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    float value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value) || (stop < end && *stop != ':' && *stop != '/'))
      return {};
    numbers.push_back(value);
    at = stop + (stop < end ? 1 : 0);
  }
  return numbers;
}

std::optional<FilterColor> hexColor(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return {};
  unsigned bits = 0;
  const auto [stop, error] = std::from_chars(text.data() + 1, text.data() + 7, bits, 16);
  if (error != std::errc() || stop != text.data() + 7) return {};
  const auto part = [&](unsigned shift) { return static_cast<float>(bits >> shift & 255U) / 255.0F; };
  return FilterColor{part(16), part(8), part(0), 1};
}

FilterValue booleanOf(const Json& json, FilterInputType type, const std::string& where) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>() != 0;  // ISF files write 0 and 1
  fail(where, describeJson(json), type);
}

FilterValue listOf(const Json& json, FilterInputType type, const std::string& where) {
  const size_t most = type == FilterInputType::Point2D ? 2 : 4;
  const size_t fewest = type == FilterInputType::Point2D ? 2 : 3;
  if (!json.is_array() || json.size() < fewest || json.size() > most) fail(where, describeJson(json), type);
  FilterColor values{0, 0, 0, 1};
  for (size_t i = 0; i < json.size(); ++i) {
    const std::optional<float> value = finite(json[i]);
    if (!value) fail(where, describeJson(json[i]), type);
    values[i] = *value;
  }
  if (type == FilterInputType::Point2D) return FilterPoint{values[0], values[1]};
  return values;
}

FilterVector vectorOf(const Json& json, FilterInputType type, const std::string& where) {
  if (!json.is_array() || json.size() < 2 || json.size() > 4) fail(where, describeJson(json), type);
  FilterVector vector;
  for (const Json& number : json) {
    const std::optional<float> value = finite(number);
    if (!value) fail(where, describeJson(number), type);
    vector.push_back(*value);
  }
  return vector;
}

FilterMatrix matrixOf(const Json& json, const std::string& where) {
  constexpr auto kType = FilterInputType::Matrix;
  if (!json.is_array() || json.size() < 2 || json.size() > 4) fail(where, describeJson(json), kType);
  FilterMatrix matrix;
  for (const Json& row : json) {
    matrix.push_back(vectorOf(row, kType, where));
    if (matrix.back().size() != json.size()) fail(where, row.dump() + " as a row", kType);
  }
  return matrix;
}

FilterCurve curveOf(const Json& json, const std::string& where) {
  constexpr auto kType = FilterInputType::Curve;
  if (!json.is_array() || json.size() < 2 || json.size() > kMostCurvePoints)
    fail(where, json.is_array() ? fmt::format("of {} points", json.size()) : describeJson(json), kType);
  FilterCurve curve;
  for (const Json& point : json) {
    const FilterVector xy = vectorOf(point, kType, where);
    const bool right =
        xy.size() == 2 && xy[0] >= 0 && xy[0] <= 1 && (curve.empty() || xy[0] > curve.back()[0]);
    if (!right) fail(where, point.dump() + fmt::format(" as point {}", curve.size() + 1), kType);
    curve.push_back({xy[0], xy[1]});
  }
  return curve;
}

/// Rows of numbers, as JSON has them: `columns` a row.
Json rowsOf(const std::vector<float>& numbers, size_t columns) {
  Json rows = Json::array();
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (i % columns == 0) rows.push_back(Json::array());
    rows.back().push_back(numbers[i]);
  }
  return rows;
}

template <typename Rows>
Json jsonFromRows(const Rows& rows) {
  Json json = Json::array();
  for (const auto& row : rows) {
    Json numbers = Json::array();
    for (const float number : row) numbers.push_back(jsonNumber(number));
    json.push_back(std::move(numbers));
  }
  return json;
}

template <typename Rows>
std::string textFromRows(const Rows& rows) {
  std::string text;
  for (const auto& row : rows) text += fmt::format("{}{}", text.empty() ? "" : "/", fmt::join(row, ":"));
  return text;
}

}  // namespace

const char* inputTypeName(FilterInputType type) {
  return rowOf(type).name;
}

std::optional<FilterInputType> inputTypeFromIsf(const std::string& name) {
  return typeAmong(std::span(kTypes).first(kIsfTypes), name);
}

std::optional<FilterInputType> ownInputType(const std::string& name) {
  return typeAmong(std::span(kTypes).subspan(kIsfTypes), name);
}

Json jsonFromFilterValue(const FilterValue& value) {
  struct Writer {
    Json operator()(bool v) const { return v; }
    Json operator()(int v) const { return v; }
    Json operator()(float v) const { return jsonNumber(v); }
    Json operator()(const FilterPoint& v) const { return {jsonNumber(v[0]), jsonNumber(v[1])}; }
    Json operator()(const FilterColor& v) const {
      return {jsonNumber(v[0]), jsonNumber(v[1]), jsonNumber(v[2]), jsonNumber(v[3])};
    }
    Json operator()(const std::string& v) const { return v; }
    Json operator()(const FilterVector& v) const { return jsonFromRows(FilterMatrix{v}).front(); }
    Json operator()(const FilterMatrix& v) const { return jsonFromRows(v); }
    Json operator()(const FilterCurve& v) const { return jsonFromRows(v); }
  };
  return std::visit(Writer{}, value);
}

FilterValue filterValueFromJson(const Json& json, FilterInputType type, const std::string& where) {
  switch (type) {
    case FilterInputType::Event:
    case FilterInputType::Bool:
      return booleanOf(json, type, where);
    case FilterInputType::Choice:
      if (!json.is_number() || json.get<double>() != std::floor(json.get<double>()) ||
          std::abs(json.get<double>()) > 1e9)
        fail(where, describeJson(json), type);
      return static_cast<int>(json.get<double>());
    case FilterInputType::Float:
      if (const std::optional<float> value = finite(json)) return *value;
      fail(where, describeJson(json), type);
    case FilterInputType::Point2D:
    case FilterInputType::Color:
      return listOf(json, type, where);
    case FilterInputType::Image:
    case FilterInputType::Audio:
    case FilterInputType::AudioSpectrum:
      if (!json.is_string()) fail(where, describeJson(json), type);
      return json.get<std::string>();
    case FilterInputType::Vector:
      return vectorOf(json, type, where);
    case FilterInputType::Matrix:
      return matrixOf(json, where);
    case FilterInputType::Curve:
      return curveOf(json, where);
  }
  return 0.0F;
}

std::string textFromFilterValue(const FilterValue& value) {
  struct Writer {
    std::string operator()(bool v) const { return v ? "on" : "off"; }
    std::string operator()(int v) const { return fmt::format("{}", v); }
    std::string operator()(float v) const { return fmt::format("{}", v); }
    std::string operator()(const FilterPoint& v) const { return fmt::format("{}:{}", v[0], v[1]); }
    std::string operator()(const FilterColor& v) const { return fmt::format("{}", fmt::join(v, ":")); }
    std::string operator()(const std::string& v) const { return v; }
    std::string operator()(const FilterVector& v) const { return textFromRows(FilterMatrix{v}); }
    std::string operator()(const FilterMatrix& v) const { return textFromRows(v); }
    std::string operator()(const FilterCurve& v) const { return textFromRows(v); }
  };
  return std::visit(Writer{}, value);
}

FilterValue filterValueFromText(const std::string& text, FilterInputType type, const std::string& where) {
  const std::string found = fmt::format("\"{}\"", text);
  switch (type) {
    case FilterInputType::Event:
    case FilterInputType::Bool:
      if (text == "on" || text == "true" || text == "yes" || text == "1") return true;
      if (text == "off" || text == "false" || text == "no" || text == "0") return false;
      throw InputError("{}: is {}, expected on or off", where, found);
    case FilterInputType::Image:
    case FilterInputType::Audio:
    case FilterInputType::AudioSpectrum:
      return text;
    case FilterInputType::Color:
      if (const std::optional<FilterColor> color = hexColor(text)) return *color;
      break;
    case FilterInputType::Choice:
    case FilterInputType::Float:
    case FilterInputType::Point2D:
    case FilterInputType::Vector:
    case FilterInputType::Matrix:
    case FilterInputType::Curve:
      break;
  }
  const std::vector<float> numbers = numbersOf(text);
  const auto checked = [&](const Json& json, const char* example) {
    try {
      return filterValueFromJson(json, type, where);
    } catch (const InputError&) {  // it quotes JSON, which nobody has typed
      fail(where, found + " (write " + example + ")", type);
    }
  };
  if (type == FilterInputType::Vector) return checked(Json(numbers), "1:0.5:0.25");
  if (type == FilterInputType::Curve) return checked(rowsOf(numbers, 2), "0:0/0.5:0.7/1:1");
  if (type == FilterInputType::Matrix) {
    const auto side = static_cast<size_t>(std::lround(std::sqrt(static_cast<double>(numbers.size()))));
    return checked(rowsOf(numbers, std::max<size_t>(side, 1)), "1:0:0/0:1:0/0:0:1");
  }
  if (type == FilterInputType::Float || type == FilterInputType::Choice) {
    if (numbers.size() != 1) fail(where, found, type);
    return filterValueFromJson(Json(numbers[0]), type, where);
  }
  const size_t fewest = type == FilterInputType::Point2D ? 2 : 3;
  if (numbers.size() < fewest || numbers.size() > (type == FilterInputType::Point2D ? 2U : 4U))
    fail(where,
         found + (type == FilterInputType::Point2D ? " (write 0.5:0.5)" : " (write 1:0.5:0, or #ff8000)"),
         type);
  return filterValueFromJson(Json(numbers), type, where);
}

FilterValue valueOfType(const FilterValue& value, FilterInputType type, const std::string& where) {
  if (const auto* text = std::get_if<std::string>(&value)) return filterValueFromText(*text, type, where);
  return filterValueFromJson(jsonFromFilterValue(value), type, where);
}

}  // namespace swaplight
