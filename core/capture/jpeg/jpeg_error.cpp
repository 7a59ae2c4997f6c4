#include "core/capture/jpeg/jpeg_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/base/quantile.h"

namespace swaplight {
namespace {

constexpr int kSide = 8;
constexpr int kPixels = kSide * kSide;
constexpr int kParts = 3;         // Y, Cb, Cr
constexpr double kRegions = 400;  // that are looked at, about
constexpr int kRounds = 6;        // of expectation-maximisation
/// Exponents by which a block's contrast may fall with frequency: those of natural pictures lie between.
constexpr double kFalls[] = {.8, 1.2, 1.6, 2, 2.4};
constexpr double kLeastScale = 1e-3;
constexpr size_t kLevels = 12;  // of brightness
constexpr size_t kFewest = 12;  // blocks and channels a level
constexpr double kCodes = 255;
constexpr double kRounding = 2 / 12.0;  // codes^2: Y, Cb, Cr are whole ones before and after the transform

/// JFIF 1.02: Y, Cb, Cr of R, G, B, and back.
constexpr double kFromRgb[kParts][3] = {
    {.299, .587, .114}, {-.168736, -.331264, .5}, {.5, -.418688, -.081312}};
constexpr double kToRgb[3][kParts] = {{1, 0, 1.402}, {1, -.344136, -.714136}, {1, 1.772, 0}};

using Block = std::array<double, kPixels>;

/// Pixels of a block of stored values: each is the mean of x by y pixels.
Block storedValues(ImageView codes, int left, int top, int part, int x, int y) {
  Block block{};
  for (int j = 0; j < kPixels; ++j) {
    double sum = 0;
    for (int line = 0; line < y; ++line)
      for (int column = 0; column < x; ++column)
        for (int c = 0; c < 3; ++c)
          sum += kFromRgb[part][c] *
                 double(codes.row(c, top + j / kSide * y + line)[left + j % kSide * x + column]);
    block[size_t(j)] = kCodes * sum / (x * y);
  }
  return block;
}

/// The cosine transform, orthonormal as JPEG's is.
Block transformed(const Block& block) {
  static const auto wave = [] {
    std::array<std::array<double, kSide>, kSide> rows{};
    for (int f = 0; f < kSide; ++f)
      for (int x = 0; x < kSide; ++x)
        rows[size_t(f)][size_t(x)] =
            std::sqrt((f ? 2.0 : 1.0) / kSide) * std::cos((2 * x + 1) * f * M_PI / (2 * kSide));
    return rows;
  }();
  Block across{}, both{};
  for (size_t y = 0; y < kSide; ++y)
    for (size_t f = 0; f < kSide; ++f)
      for (size_t x = 0; x < kSide; ++x) across[kSide * y + f] += wave[f][x] * block[kSide * y + x];
  for (size_t g = 0; g < kSide; ++g)
    for (size_t f = 0; f < kSide; ++f)
      for (size_t y = 0; y < kSide; ++y) both[kSide * g + f] += wave[g][y] * across[kSide * y + f];
  return both;
}

/// A Laplace variable of the scale b that is known to lie within h of 0: mean of its magnitude, variance.
double meanWithin(double b, double h) {
  const double beyond = std::exp(-h / b);
  return b - h * beyond / std::max(1 - beyond, 1e-12);
}
double varianceWithin(double b, double h) {
  const double beyond = std::exp(-h / b);
  return std::clamp(2 * b * b - h * (h + 2 * b) * beyond / std::max(1 - beyond, 1e-12), 0.0, h * h / 3);
}

/// The logarithm of the chance that a Laplace variable of the scale b is rounded to `steps` (>= 0) of q.
double logChance(double b, double q, double steps) {
  if (steps <= 0) return std::log1p(-std::exp(-q / (2 * b)));
  return std::log1p(-std::exp(-q / b)) - (steps - .5) * q / b - M_LN2;
}

/// The scale of every coefficient: a block's contrast over frequency to the power of `fall`.
struct Spectrum {
  double logChance = -INFINITY;
  Block weight{};                ///< frequency to that power
  std::vector<double> contrast;  ///< of every block

  [[nodiscard]] double scale(size_t block, size_t j) const {
    return std::max(contrast[block] / weight[j], kLeastScale);
  }
};

/// The blocks of one part of the picture, and how it rounds them.
class Coefficients {
 public:
  explicit Coefficients(const std::array<uint16_t, kPixels>& steps) {
    for (size_t j = 0; j < kPixels; ++j) m_step[j] = std::max<double>(steps[j], 1);
  }

  void add(const Block& block) {
    Block rounded = transformed(block);
    for (size_t j = 0; j < kPixels; ++j) rounded[j] = std::abs(std::round(rounded[j] / m_step[j]));
    m_rounded.push_back(rounded);
  }

  /// Mean squared error of a value, of every block.
  [[nodiscard]] std::vector<double> errors() const {
    Spectrum best;
    for (const double fall : kFalls)
      if (Spectrum spectrum = spectrumOf(fall); spectrum.logChance > best.logChance || best.contrast.empty())
        best = std::move(spectrum);
    std::vector<double> errors;
    for (size_t b = 0; b < m_rounded.size(); ++b) {
      double sum = m_step[0] * m_step[0] / 12;
      for (size_t j = 1; j < kPixels; ++j)
        sum += m_rounded[b][j] > 0 ? m_step[j] * m_step[j] / 12
                                   : varianceWithin(best.scale(b, j), m_step[j] / 2);
      errors.push_back(kRounding + sum / kPixels);
    }
    return errors;
  }

 private:
  [[nodiscard]] Spectrum spectrumOf(double fall) const {
    Spectrum spectrum;
    for (size_t j = 1; j < kPixels; ++j)
      spectrum.weight[j] = std::pow(std::hypot(double(j / kSide), double(j % kSide)), fall);
    spectrum.contrast.assign(m_rounded.size(), m_step[1]);
    double typical = m_step[1];
    for (int round = 0; round < kRounds; ++round) {
      double sum = 0;
      for (size_t b = 0; b < m_rounded.size(); ++b)
        sum += spectrum.contrast[b] = contrastOf(b, spectrum, typical);
      typical = sum / std::max<double>(double(m_rounded.size()), 1);
    }
    spectrum.logChance = 0;
    for (size_t b = 0; b < m_rounded.size(); ++b)
      for (size_t j = 1; j < kPixels; ++j)
        spectrum.logChance += logChance(spectrum.scale(b, j), m_step[j], m_rounded[b][j]);
    return spectrum;
  }
  /// One step; a block of nothing but zeros has the typical contrast once among its coefficients.
  [[nodiscard]] double contrastOf(size_t b, const Spectrum& spectrum, double typical) const {
    double sum = typical;
    for (size_t j = 1; j < kPixels; ++j)
      sum += spectrum.weight[j] * (m_rounded[b][j] > 0 ? m_rounded[b][j] * m_step[j]
                                                       : meanWithin(spectrum.scale(b, j), m_step[j] / 2));
    return sum / kPixels;
  }

  Block m_step{};
  std::vector<Block> m_rounded;
};

/// What varies among groups of x by y values: the octave below that of single ones.
double variesAmong(const Block& block, int x, int y) {
  double within = 0;
  int used = 0;
  for (int top = 0; top + y <= kSide; top += y)
    for (int left = 0; left + x <= kSide; left += x) {
      double sum = 0, squares = 0;
      for (int line = top; line < top + y; ++line)
        for (int column = left; column < left + x; ++column) {
          const double value = block[size_t(line * kSide + column)];
          sum += value;
          squares += value * value;
        }
      within += squares - sum * sum / (x * y);
      used += x * y;
    }
  return std::max(within / std::max(used, 1), 0.0);
}

/// Regions of a block of colour each, and the several blocks of Y that lie there.
struct Regions {
  std::vector<std::array<double, 3>> mean;    ///< code 0..1 of R, G, B
  std::vector<std::array<double, 2>> merged;  ///< variance lost to stored values of several pixels: Cb, Cr
  std::vector<Coefficients> parts;
};

Regions look(ImageView codes, const JpegCoding& coding) {
  Regions regions;
  for (const auto& steps : coding.steps) regions.parts.emplace_back(steps);
  const int wide = kSide * coding.chromaX, high = kSide * coding.chromaY;
  const int columns = codes.width / wide, rows = codes.height / high;
  const int every = std::max(1, int(std::sqrt(double(columns) * rows / kRegions)));
  for (int row = 0; row < rows; row += every)
    for (int column = 0; column < columns; column += every) {
      const int left = column * wide, top = row * high;
      auto& mean = regions.mean.emplace_back();
      for (int c = 0; c < 3; ++c)
        for (int y = top; y < top + high; ++y)
          for (int x = left; x < left + wide; ++x)
            mean[size_t(c)] += double(codes.row(c, y)[x]) / (wide * high);
      for (int y = top; y < top + high; y += kSide)
        for (int x = left; x < left + wide; x += kSide)
          regions.parts[0].add(storedValues(codes, x, y, 0, 1, 1));
      auto& merged = regions.merged.emplace_back();
      for (int part = 1; part < kParts; ++part) {
        const Block block = storedValues(codes, left, top, part, coding.chromaX, coding.chromaY);
        merged[size_t(part - 1)] = variesAmong(block, coding.chromaX, coding.chromaY);
        regions.parts[size_t(part)].add(block);
      }
    }
  return regions;
}

}  // namespace

std::vector<ValueVariance> jpegError(ImageView codes, const JpegCoding& coding) {
  const Regions regions = look(codes, coding);
  std::array<std::vector<double>, kParts> errors;
  for (size_t part = 0; part < kParts; ++part) errors[part] = regions.parts[part].errors();
  const size_t ofLuma = size_t(coding.chromaX * coding.chromaY);

  struct Level {
    double value = 0;
    std::vector<float> variance;
  };
  std::array<Level, kLevels> levels{};
  for (size_t r = 0; r < regions.mean.size(); ++r) {
    double variance[kParts] = {0, errors[1][r] + regions.merged[r][0], errors[2][r] + regions.merged[r][1]};
    for (size_t j = 0; j < ofLuma; ++j) variance[0] += errors[0][r * ofLuma + j] / double(ofLuma);
    for (size_t c = 0; c < 3; ++c) {
      const double value = std::clamp(regions.mean[r][c], 0.0, 1.0);
      Level& level = levels[std::min(size_t(value * kLevels), kLevels - 1)];
      level.value += value;
      float& sum = level.variance.emplace_back();
      for (size_t part = 0; part < kParts; ++part)
        sum += float(kToRgb[c][part] * kToRgb[c][part] * variance[part] / (kCodes * kCodes));
    }
  }
  std::vector<ValueVariance> points;
  for (Level& level : levels)
    if (level.variance.size() >= kFewest)
      points.push_back(
          {float(level.value / double(level.variance.size())), median(std::span(level.variance))});
  return points;
}

}  // namespace swaplight
