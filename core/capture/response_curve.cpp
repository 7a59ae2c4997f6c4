#include "core/capture/response_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/file/atomic_file.h"

namespace swaplight {
namespace {

constexpr size_t kCurveCodes = 4096;    // between whose light is interpolated: 12 bits
constexpr size_t kMostBytes = 1 << 24;  // of a file: 16 bits have 65536 codes
constexpr int kResponseRows = 64;       // at once

/// A line of the file: a code and its light.
struct ResponsePoint {
  double code = 0;
  std::array<double, 3> light{};
};

std::optional<float> responseNumber(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return std::nullopt;
  return numberFromText(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

/// Nothing where the line holds no numbers.
std::optional<ResponsePoint> pointOf(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream fields(line);
  for (std::string field; std::getline(fields, field, ',');) {
    const auto value = responseNumber(field);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  if (numbers.size() == 2) return ResponsePoint{numbers[0], {numbers[1], numbers[1], numbers[1]}};
  if (numbers.size() == 4) return ResponsePoint{numbers[0], {numbers[1], numbers[2], numbers[3]}};
  return std::nullopt;
}

void checkPoint(const ResponsePoint& point, const ResponsePoint* before, const std::string& where) {
  const bool light = std::all_of(point.light.begin(), point.light.end(), [](double l) { return l >= 0; });
  if (point.code < 0 || point.code > 1 || !light)
    throw InputError("{}: codes go from 0 to 1, and light is not negative", where);
  if (!before) return;
  for (size_t c = 0; c < 3; ++c)
    if (!(point.code > before->code) || point.light[c] < before->light[c])
      throw InputError("{}: codes and their light have to rise from line to line", where);
}

std::vector<ResponsePoint> readPoints(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw InputError("{}: is not there: a camera's response was expected, as swaplight response writes it",
                     file.string());
  std::istringstream in(readFile(file, kMostBytes));
  std::vector<ResponsePoint> points;
  size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string where = fmt::format("{}: line {}", file.string(), number);
    const auto point = pointOf(line);
    if (!point && points.empty()) continue;  // names of the columns
    if (!point) throw InputError("{}: expected code,red,green,blue or code,light", where);
    checkPoint(*point, points.empty() ? nullptr : &points.back(), where);
    points.push_back(*point);
  }
  if (points.size() < 2 || points.front().code > 0.01 || points.back().code < 0.99)
    throw InputError("{}: expected lines code,red,green,blue for codes from 0 to 1", file.string());
  for (const double light : points.back().light)
    if (!(light > 0)) throw InputError("{}: the last line has no light", file.string());
  return points;
}

}  // namespace

float ResponseCurve::at(int channel, float code) const {
  const std::vector<float>& curve = light[static_cast<size_t>(channel)];
  const float place = code * static_cast<float>(curve.size() - 1);
  if (!(place > 0)) return std::isnan(code) ? code : curve.front();
  const size_t below = std::min(static_cast<size_t>(std::min(place, 1e6F)), curve.size() - 2);
  return curve[below] + (place - static_cast<float>(below)) * (curve[below + 1] - curve[below]);
}

void ResponseCurve::apply(const ImageSpan& pixels) const {
  parallelRows(pixels.height, kResponseRows, [&](int begin, int end) {
    for (int c = 0; c < 3; ++c)
      for (int y = begin; y < end; ++y) {
        float* row = pixels.row(c, y);
        for (int x = 0; x < pixels.width; ++x) row[x] = at(c, row[x]);
      }
  });
}

bool isResponseFile(const std::string& colorSpace) {
  return colorSpace.size() > 4 && lowerCase(colorSpace).ends_with(".csv");
}

void checkResponseFile(const std::string& name, const std::string& where) {
  if (!isResponseFile(name)) throw InputError("{} {}: a response is a file .csv", where, name);
}

ResponseCurve readResponse(const std::filesystem::path& file) {
  const std::vector<ResponsePoint> points = readPoints(file);
  ResponseCurve curve;
  for (size_t c = 0; c < 3; ++c) {
    size_t next = 1;
    for (size_t k = 0; k < kCurveCodes; ++k) {
      const double code = static_cast<double>(k) / (kCurveCodes - 1);
      while (next + 1 < points.size() && points[next].code < code) ++next;
      const ResponsePoint &a = points[next - 1], &b = points[next];
      const double part = (code - a.code) / (b.code - a.code);
      curve.light[c].push_back(
          static_cast<float>(std::max(a.light[c] + part * (b.light[c] - a.light[c]), 0.0)));
    }
  }
  return curve;
}

void writeResponse(const ResponseCurve& curve, const std::filesystem::path& file) {
  std::string text = "code,red,green,blue\n";
  const size_t count = curve.light[0].size();
  for (size_t k = 0; k < count; ++k)
    text +=
        fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}\n", static_cast<double>(k) / static_cast<double>(count - 1),
                    curve.light[0][k], curve.light[1][k], curve.light[2][k]);
  writeFile(file, text);
}

}  // namespace swaplight
