#include "core/solve/highlights/highlight_surroundings.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr int kCells = 120;            // along the longer side
constexpr int kSamplesAcross = 2;      // of a cell
constexpr int kErrorRadius = 6;        // cells
constexpr int kRadii[] = {6, 12, 24};  // cells: the first in which enough is seen
constexpr double kEnough = 0.25;       // of the window's pixels
constexpr float kSwamped = 2.5F;       // times the error around
constexpr float kSeen = 4;             // standard errors that a light has to have
constexpr float kSure = 3;             // standard errors
constexpr float kLeastError = 1e-3F;   // of the set's mean light

/// Sums over cells, of windows around any of them in constant time (Crow 1984).
class WindowSums {
 public:
  WindowSums(const std::vector<double>& cells, int columns, int rows)
      : m_columns(columns), m_rows(rows), m_sum(size_t(columns + 1) * size_t(rows + 1), 0.0) {
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x)
        m_sum[index(x + 1, y + 1)] =
            cells[size_t(y) * size_t(columns) + size_t(x)] + at(x, y + 1) + at(x + 1, y) - at(x, y);
  }
  [[nodiscard]] double around(int x, int y, int radius) const {
    const int left = std::max(0, x - radius), right = std::min(m_columns, x + radius + 1);
    const int top = std::max(0, y - radius), bottom = std::min(m_rows, y + radius + 1);
    return at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
  }

 private:
  [[nodiscard]] size_t index(int x, int y) const { return size_t(y) * size_t(m_columns + 1) + size_t(x); }
  [[nodiscard]] double at(int x, int y) const { return m_sum[index(x, y)]; }
  int m_columns, m_rows;
  std::vector<double> m_sum;
};

}  // namespace

HighlightSurroundings::HighlightSurroundings(const SolvedSet& set)
    : m_width(set.width()),
      m_height(set.height()),
      m_side(std::max(1, (std::max(m_width, m_height) + kCells - 1) / kCells)),
      m_step(std::max(1, m_side / kSamplesAcross)),
      m_columns((m_width + m_side - 1) / m_side),
      m_rows((m_height + m_side - 1) / m_side),
      m_lights(set.lightCount()) {
  takeSamples(set);
  if (!(m_leastError > 0)) return;
  measureErrors();
  measureSurfaces();
}

void HighlightSurroundings::takeSamples(const SolvedSet& set) {
  double sum = 0;
  for (int y = m_step / 2; y < m_height; y += m_step)
    for (int x = m_step / 2; x < m_width; x += m_step) {
      m_samples.push_back(saturationAt(set, size_t(y) * size_t(m_width) + size_t(x), 0));
      for (int i = 0; i < m_lights; ++i) sum += double{m_samples.back().mean[size_t(i)]};
    }
  m_leastError = kLeastError * float(sum / double(std::max<size_t>(m_samples.size(), 1)));
  for (LightSaturation& pixel : m_samples) pixel.error = std::max(pixel.error, m_leastError);
}

void HighlightSurroundings::measureErrors() {
  const size_t cells = size_t(m_columns) * size_t(m_rows);
  std::vector<double> logs(cells, 0.0), counts(cells, 0.0);
  eachSample([&](int x, int y, const LightSaturation& pixel) {
    logs[cellOf(x, y)] += double{std::log(pixel.error)};
    counts[cellOf(x, y)] += 1;
  });
  const WindowSums sums(logs, m_columns, m_rows), numbers(counts, m_columns, m_rows);
  m_error.resize(cells);
  for (int y = 0; y < m_rows; ++y)
    for (int x = 0; x < m_columns; ++x)
      m_error[size_t(y) * size_t(m_columns) + size_t(x)] = float(
          std::exp(sums.around(x, y, kErrorRadius) / std::max(numbers.around(x, y, kErrorRadius), 1.0)));
}

void HighlightSurroundings::measureSurfaces() {
  const size_t cells = size_t(m_columns) * size_t(m_rows);
  // All samples, those whose surface is seen, their saturation and its square, and each light.
  std::vector<std::vector<double>> values(size_t(4 + m_lights), std::vector<double>(cells, 0.0));
  eachSample([&](int x, int y, const LightSaturation& pixel) {
    const size_t cell = cellOf(x, y);
    values[0][cell] += 1;
    const float brightest = *std::max_element(pixel.mean.begin(), pixel.mean.begin() + m_lights);
    if (brightest <= kSeen * pixel.error || pixel.error > kSwamped * m_error[cell]) return;
    const auto saturation = double{pixel.surest(kSure)};
    values[1][cell] += 1;
    values[2][cell] += saturation;
    values[3][cell] += saturation * saturation;
    for (int i = 0; i < m_lights; ++i) values[size_t(4 + i)][cell] += double{pixel.mean[size_t(i)]};
  });
  std::vector<WindowSums> sums;
  for (const auto& plane : values) sums.emplace_back(plane, m_columns, m_rows);
  m_saturation.assign(cells, 0.0F);
  m_leastSaturation.assign(cells, 0.0F);
  m_level.assign(cells * size_t(m_lights), 0.0F);
  for (int y = 0; y < m_rows; ++y)
    for (int x = 0; x < m_columns; ++x)
      for (const int radius : kRadii) {
        const double seen = sums[1].around(x, y, radius);
        if (seen < std::max(kEnough * sums[0].around(x, y, radius), 1.0)) continue;
        const size_t cell = size_t(y) * size_t(m_columns) + size_t(x);
        const double mean = sums[2].around(x, y, radius) / seen;
        const double square = sums[3].around(x, y, radius) / seen;
        const double spread = std::sqrt(std::max(square - mean * mean, 0.0));
        m_saturation[cell] = float(mean);
        m_leastSaturation[cell] = float(std::max(mean - spread, mean / 3));
        for (int i = 0; i < m_lights; ++i)
          m_level[cell * size_t(m_lights) + size_t(i)] =
              float(sums[size_t(4 + i)].around(x, y, radius) / seen);
        break;
      }
}

HighlightSurroundings::Place HighlightSurroundings::at(int x, int y) const {
  const size_t cell = cellOf(x, y);
  return {m_error[cell], m_saturation[cell], m_leastSaturation[cell], &m_level[cell * size_t(m_lights)]};
}

bool HighlightSurroundings::isSwamped(const LightSaturation& pixel, const Place& place) {
  return pixel.error > kSwamped * place.error;
}

}  // namespace swaplight
