#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "core/color/chromaticity.h"
#include "core/lamp/gel.h"

namespace swaplight {
namespace {

enum Column { kBrand, kNumber, kName, kX, kY, kT, kColumns };
constexpr std::array<const char*, kColumns> kColumnNames{"brand", "number", "name", "x", "y", "t"};

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

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Which field holds which column, where the line names them.
std::optional<std::array<size_t, kColumns>> columnsOf(const std::vector<std::string>& fields) {
  std::array<size_t, kColumns> columns{};
  for (size_t c = 0; c < kColumns; ++c) {
    const auto named = std::find_if(fields.begin(), fields.end(), [&](const std::string& field) {
      return lowerCase(field) == kColumnNames[c];
    });
    if (named == fields.end()) return std::nullopt;
    columns[c] = static_cast<size_t>(named - fields.begin());
  }
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

Gel gelFromFields(const std::array<std::string, kColumns>& fields, const std::string& where) {
  const auto in = [&](Column column, double low, double high) {
    const auto value = number(fields[column]);
    if (!value || !(*value > low && *value <= high))
      throw InputError("{}: {} is '{}'; it must be a number above {} and at most {}", where,
                       kColumnNames[column], fields[column], low, high);
    return *value;
  };
  Gel gel;
  gel.id = fields[kBrand].substr(0, 1) + fields[kNumber];
  if (fields[kBrand].empty() || fields[kNumber].empty())
    throw InputError("{}: brand and number must both be there, as Lee,201", where);
  gel.id[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(gel.id[0])));
  gel.name = fields[kName];
  const Chromaticity xy{in(kX, 0, 1), in(kY, 0, 1)};
  const double t = in(kT, 0, 100);
  gel.transmission = static_cast<float>(t > 1 ? t / 100 : t);
  gel.filter = gel.transmission * rec709FromXy(xy);
  return gel;
}

}  // namespace

std::vector<Gel> gelsFromCsv(const std::string& text, const std::string& fileName) {
  std::array<size_t, kColumns> columns{0, 1, 2, 3, 4, 5};
  std::vector<Gel> gels;
  std::istringstream lines(text);
  std::string line;
  bool first = true;
  for (int count = 1; std::getline(lines, line); ++count) {
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    const std::vector<std::string> fields = fieldsOf(line);
    if (first) {
      first = false;
      if (const auto named = columnsOf(fields)) {
        columns = *named;
        continue;
      }
    }
    const std::string where = fmt::format("{}: line {}", fileName, count);
    if (fields.size() <= *std::max_element(columns.begin(), columns.end()))
      throw InputError("{}: has {} columns; expected are brand,number,name,x,y,T", where, fields.size());
    std::array<std::string, kColumns> ordered;
    for (size_t c = 0; c < kColumns; ++c) ordered[c] = fields[columns[c]];
    gels.push_back(gelFromFields(ordered, where));
  }
  return gels;
}

}  // namespace swaplight
