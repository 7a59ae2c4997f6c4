#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <sstream>
#include <utility>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/color/chromaticity.h"
#include "core/lamp/gel.h"

namespace swaplight {
namespace {

enum Column { kBrand, kNumber, kName, kX, kY, kT, kColumns };
constexpr std::array<const char*, kColumns> kColumnNames{"brand", "number", "name", "x", "y", "t"};
constexpr const char* kSource = "source";  // a column that may be there
constexpr float kMostPassed = 1.05F;       // noise and a lamp that wanders let a clear gel pass more than all
constexpr const char* kNewTable = "brand,number,name,x,y,T,source\n";

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The fields of a line (RFC 4180: a field in quotes may hold commas, and a quote as two).
std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[i++];
      else
        quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  for (std::string& field : fields) field = trimmed(field);
  return fields;
}

struct Columns {
  std::array<size_t, kColumns> places{0, 1, 2, 3, 4, 5};
  std::optional<size_t> source;
};

std::optional<size_t> placeOf(const std::vector<std::string>& fields, const char* name) {
  const auto named = std::find_if(fields.begin(), fields.end(),
                                  [&](const std::string& field) { return lowerCase(field) == name; });
  if (named == fields.end()) return std::nullopt;
  return static_cast<size_t>(named - fields.begin());
}

/// Which field holds which column, where the line names them.
std::optional<Columns> columnsOf(const std::vector<std::string>& fields) {
  Columns columns;
  for (size_t c = 0; c < kColumns; ++c) {
    const auto named = placeOf(fields, kColumnNames[c]);
    if (!named) return std::nullopt;
    columns.places[c] = *named;
  }
  columns.source = placeOf(fields, kSource);
  return columns;
}

std::optional<double> number(std::string text) {
  const bool percent = !text.empty() && text.back() == '%';
  if (percent) text.pop_back();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return percent ? value / 100 : value;
}

std::string idOf(const std::string& brand, const std::string& number) {
  std::string id = brand.substr(0, 1) + number;
  id[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(id[0])));
  return id;
}

Gel gelFromFields(const std::array<std::string, kColumns>& fields, const std::string& where) {
  const auto in = [&](Column column, double low, double high) {
    const auto value = number(fields[column]);
    if (!value || !(*value > low && *value <= high))
      throw InputError("{}: {} is '{}'; it must be a number above {} and at most {}", where,
                       kColumnNames[column], fields[column], low, high);
    return *value;
  };
  Gel gel;
  if (fields[kBrand].empty() || fields[kNumber].empty())
    throw InputError("{}: brand and number must both be there, as Lee,201", where);
  gel.id = idOf(fields[kBrand], fields[kNumber]);
  gel.name = fields[kName];
  const Chromaticity xy{in(kX, 0, 1), in(kY, 0, 1)};
  const double t = in(kT, 0, 100);
  gel.transmission = static_cast<float>(t > 1 ? t / 100 : t);
  gel.filter = gel.transmission * rec709FromXy(xy);
  return gel;
}

/// A table's lines with their numbers, but for empty ones and comments, and what its columns are.
struct Table {
  Columns columns;
  std::vector<std::pair<int, std::vector<std::string>>> rows;
};

Table tableFromText(const std::string& text) {
  Table table;
  std::istringstream lines(text);
  std::string line;
  bool first = true;
  for (int count = 1; std::getline(lines, line); ++count) {
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    std::vector<std::string> fields = fieldsOf(line);
    const auto named = first ? columnsOf(fields) : std::nullopt;
    first = false;
    if (named)
      table.columns = *named;
    else
      table.rows.emplace_back(count, std::move(fields));
  }
  return table;
}

/// As a table has it: in quotes where it has commas or quotes, or what would begin a comment.
std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"#") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

}  // namespace

std::vector<Gel> gelsFromCsv(const std::string& text, const std::string& fileName) {
  const Table table = tableFromText(text);
  const auto& places = table.columns.places;
  std::vector<Gel> gels;
  for (const auto& [count, fields] : table.rows) {
    const std::string where = fmt::format("{}: line {}", fileName, count);
    if (fields.size() <= *std::max_element(places.begin(), places.end()))
      throw InputError("{}: has {} columns; expected are brand,number,name,x,y,T", where, fields.size());
    std::array<std::string, kColumns> ordered;
    for (size_t c = 0; c < kColumns; ++c) ordered[c] = fields[places[c]];
    gels.push_back(gelFromFields(ordered, where));
    const auto source = table.columns.source;
    if (source && *source < fields.size() && lowerCase(fields[*source]) == sourceName(Gel::Source::Measured))
      gels.back().source = Gel::Source::Measured;
  }
  return gels;
}

GelLabel GelLabel::fromText(const std::string& text) {
  const std::vector<std::string> fields = fieldsOf(text);
  const bool plain =
      std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; });
  if (!plain || fields.size() < 2 || fields.size() > 3 || fields[0].empty() || fields[1].empty() ||
      fields[0].front() == '#')
    throw InputError("--gel {}: names no gel: write the brand, the number and, if you like, the name, as {}",
                     text, "Rosco,4660,60 Red");
  return {fields[0], fields[1], fields.size() > 2 ? fields[2] : ""};
}

std::string withMeasuredGel(const std::string& table, const std::string& fileName, const GelLabel& told,
                            const Rgb& filter) {
  const GelLabel label{trimmed(told.brand), trimmed(told.number), trimmed(told.name)};
  const std::string id = idOf(label.brand, label.number);
  for (const Gel& gel : gelsFromCsv(table, fileName))
    if (lowerCase(gel.id) == lowerCase(id))
      throw InputError("{}: has the gel {} already: take its line out, or give this one another number",
                       fileName, id);
  const float transmission = luminance(filter);
  if (!(transmission > 0))
    throw InputError("the gel {} lets nothing through: its photograph is black where the other is lit", id);
  if (transmission > kMostPassed)
    throw InputError(
        "the gel {} lets more through than there was ({:.0f} %): are the photographs with and without it "
        "swapped, or exposed differently?",
        id, 100 * transmission);
  const Chromaticity xy = xyFromRec709(filter);
  std::string text = table.find_first_not_of(" \t\r\n") == std::string::npos ? kNewTable : table;
  if (text.back() != '\n') text += '\n';
  const Columns columns = tableFromText(text).columns;
  const auto last = *std::max_element(columns.places.begin(), columns.places.end());
  std::vector<std::string> fields(std::max(last, columns.source.value_or(0)) + 1);
  fields[columns.places[kBrand]] = quoted(label.brand);
  fields[columns.places[kNumber]] = quoted(label.number);
  fields[columns.places[kName]] = quoted(label.name);
  fields[columns.places[kX]] = fmt::format("{:.5g}", xy.x);
  fields[columns.places[kY]] = fmt::format("{:.5g}", xy.y);
  fields[columns.places[kT]] = fmt::format("{:.5g}", std::min(transmission, 1.0F));
  if (columns.source) fields[*columns.source] = sourceName(Gel::Source::Measured);
  text += fmt::format("{}\n", fmt::join(fields, ","));
  static_cast<void>(gelsFromCsv(text, fileName));  // a table that cannot be read would hide all gels
  return text;
}

}  // namespace swaplight
