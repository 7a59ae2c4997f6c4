#include "core/intake/exposure_ratio.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/quantile.h"

namespace swaplight {
namespace {

// In stops. Made brackets of the rendered sets stay below a third of both, gels that change places reach
// three times as much.
constexpr double kHalfApart = 0.15;  ///< between the quartiles of squares that are alike in one picture
constexpr double kMostApart = 0.6;   ///< between their 5th and 95th hundredths

constexpr int kSide = 8;           // pixels of a square, where the picture has enough of them
constexpr size_t kSquares = 2000;  // as many as a picture shall have
constexpr size_t kLeast = 100;     // that can be compared, over all channels
constexpr size_t kBins = 12;       // of like squares
constexpr float kDark = 0.01F;     // of full scale: below, noise and black levels decide

struct Square {
  double level;  ///< log2 of the one
  double ratio;  ///< log2 of the other over the one
};

/// The mean over a square; nothing where a pixel is clipped or broken.
std::optional<float> squareMean(const CapturePixels& pixels, size_t shot, int c, int x, int y, int side) {
  const Image& image = pixels.shots[shot];
  float sum = 0;
  for (int row = y; row < y + side; ++row)
    for (int column = x; column < x + side; ++column) {
      const float value = image.view().at(c, column, row);
      if (!(value < pixels.clipLevel[shot])) return std::nullopt;
      sum += value;
    }
  sum /= static_cast<float>(side * side);
  return sum > kDark ? std::optional(sum) : std::nullopt;
}

std::vector<Square> squaresOf(const CapturePixels& pixels, size_t a, size_t b) {
  const int width = pixels.width(), height = pixels.height();
  const double room = double(width) * double(height) / double(kSquares);
  const int side = std::clamp(static_cast<int>(std::sqrt(room)), 1, kSide);
  const int step = std::max(side, static_cast<int>(std::sqrt(room / 4)));
  std::vector<Square> squares;
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y + side <= height; y += step)
      for (int x = 0; x + side <= width; x += step) {
        const auto one = squareMean(pixels, a, c, x, y, side);
        const auto other = one ? squareMean(pixels, b, c, x, y, side) : std::nullopt;
        if (other) squares.push_back({std::log2(double(*one)), std::log2(double(*other) / double(*one))});
      }
  return squares;
}

double ratioAt(std::span<const Square> squares, double q) {
  std::vector<double> ratios;
  for (const Square& square : squares) ratios.push_back(square.ratio);
  return quantile(std::span(ratios), q);
}

}  // namespace

std::optional<ExposureRatio> exposureRatio(const CapturePixels& pixels, size_t a, size_t b) {
  std::vector<Square> squares = squaresOf(pixels, a, b);
  if (squares.size() < kLeast) return std::nullopt;
  std::sort(squares.begin(), squares.end(),
            [](const Square& one, const Square& other) { return one.level < other.level; });
  const std::span<const Square> all(squares);
  std::vector<double> half, most, ratios;
  for (size_t bin = 0; bin < kBins; ++bin) {
    const size_t from = bin * all.size() / kBins, to = (bin + 1) * all.size() / kBins;
    const auto alike = all.subspan(from, to - from);
    ratios.push_back(ratioAt(alike, .5));
    if (bin < kBins / 2) continue;  // the brighter half: dark squares differ by their noise
    half.push_back(ratioAt(alike, .75) - ratioAt(alike, .25));
    most.push_back(ratioAt(alike, .95) - ratioAt(alike, .05));
  }
  if (median(std::span(half)) > kHalfApart || median(std::span(most)) > kMostApart) return std::nullopt;
  const double dark = median(std::span(ratios).first(kBins / 3));
  const double bright = median(std::span(ratios).last(kBins / 3));
  return ExposureRatio{ratioAt(all, .5), bright - dark};
}

}  // namespace swaplight
