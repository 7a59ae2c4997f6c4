#include "core/solve/highlights/crossed_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/linear/decompositions.h"
#include "core/solve/model/lighting_matrix.h"

namespace swaplight {
namespace {

constexpr int kBlock = 8;              // pixels a side
constexpr double kSame = 1e-3;         // relative: a lighting that is the sum of others
constexpr double kNoWeight = 1e-6;     // what rounding leaves of a shot that does not count
constexpr double kMostWeights = 3;     // length of what others are multiplied with: beyond it they are noise
constexpr double kBright = 0.1;        // of the 95th percentile of the blocks' light
constexpr double kMostBlocks = 20000;  // of a large picture, evenly
constexpr size_t kFewBlocks = 20;      // too few to tell
constexpr double kWidth = 0.01;        // of the place where ratios gather: of the logarithm
constexpr int kMostSteps = 50;         // of the mean shift
constexpr double kDark = 0.9;          // of the part: a block with highlights, or their want
constexpr float kMostPass = 1.05F;     // no filter lets more through
constexpr double kFewHighlights = 0.01;  // part of the blocks

/// A crossed shot's channel as a sum of the open ones'.
struct Sum {
  size_t shot;
  int channel;
  std::vector<double> weights;  ///< one a shot; 0 for crossed ones
  double ambient;               ///< what has to be added of the ambient light
};

std::optional<Sum> sumFor(const Capture& capture, const LightingMatrix& lighting, size_t shot, int channel) {
  std::vector<size_t> open;
  for (size_t k = 0; k < capture.shots.size(); ++k)
    if (!capture.shots[k].crossed) open.push_back(k);
  const auto lights = static_cast<Eigen::Index>(capture.lights.size());
  Eigen::MatrixXd columns(lights, static_cast<Eigen::Index>(open.size()));
  Eigen::VectorXd wanted(lights);
  for (int i = 0; i < capture.lightCount(); ++i) {
    for (size_t j = 0; j < open.size(); ++j)
      columns(i, static_cast<Eigen::Index>(j)) = lighting.color(static_cast<int>(open[j]), i)[channel];
    wanted(i) = lighting.color(static_cast<int>(shot), i)[channel];
  }
  // The shortest weights, so that shots that are alike share the work.
  const SingularValues parts = singularValues(columns);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(columns.cols());
  for (Eigen::Index j = 0; j < parts.values.size(); ++j)
    if (parts.values(j) > kSame * parts.values(0))
      weights += parts.v.col(j) * (parts.u.col(j).dot(wanted) / parts.values(j));
  if (!(wanted.norm() > 0) || (columns * weights - wanted).norm() > kSame * wanted.norm() ||
      weights.norm() > kMostWeights * std::sqrt(static_cast<double>(open.size())))
    return std::nullopt;
  Sum sum{shot, channel, std::vector<double>(capture.shots.size(), 0), 0};
  sum.ambient = std::exp2(capture.shots[shot].exposureStops);
  for (size_t j = 0; j < open.size(); ++j) {
    const double weight = weights(static_cast<Eigen::Index>(j));
    if (std::abs(weight) < kNoWeight) continue;
    sum.weights[open[j]] = weight;
    sum.ambient -= sum.weights[open[j]] * std::exp2(capture.shots[open[j]].exposureStops);
  }
  if (std::abs(sum.ambient) < kNoWeight) sum.ambient = 0;
  return sum;
}

struct Block {
  double crossed = 0, open = 0;
};

/// Nothing where a value of the block is not finite or clipped in a shot that counts.
std::optional<Block> blockAt(const CapturePixels& photographs, const Sum& sum, int left, int top) {
  Block block;
  const auto add = [&](const Image& image, float clip, double weight, double& to) {
    for (int y = top; y < top + kBlock; ++y)
      for (int x = left; x < left + kBlock; ++x) {
        const float value = image.view().at(sum.channel, x, y);
        if (!(value < clip)) return false;
        to += weight * double(value);
      }
    return true;
  };
  if (!add(photographs.shots[sum.shot], photographs.clipLevel[sum.shot], 1, block.crossed))
    return std::nullopt;
  for (size_t k = 0; k < sum.weights.size(); ++k)
    if (sum.weights[k] != 0 &&
        !add(photographs.shots[k], photographs.clipLevel[k], sum.weights[k], block.open))
      return std::nullopt;
  if (photographs.ambient && sum.ambient != 0 &&
      !add(*photographs.ambient, INFINITY, sum.ambient, block.open))
    return std::nullopt;
  return block;
}

/// The logarithms of the ratios, crossed over open, of a channel's bright blocks.
std::vector<double> ratiosOf(const CapturePixels& photographs, const std::vector<Sum>& sums, int channel) {
  std::vector<double> ratios;
  for (const Sum& sum : sums) {
    if (sum.channel != channel) continue;
    std::vector<Block> blocks;
    const double all = double(photographs.width()) * double(photographs.height()) / (kBlock * kBlock);
    const int step = kBlock * std::max(1, static_cast<int>(std::ceil(std::sqrt(all / kMostBlocks))));
    for (int y = 0; y + kBlock <= photographs.height(); y += step)
      for (int x = 0; x + kBlock <= photographs.width(); x += step)
        if (const auto block = blockAt(photographs, sum, x, y)) blocks.push_back(*block);
    if (blocks.empty()) continue;
    const auto high = blocks.begin() + static_cast<ptrdiff_t>(blocks.size() * 95 / 100);
    std::nth_element(blocks.begin(), high, blocks.end(),
                     [](const Block& a, const Block& b) { return a.open < b.open; });
    const double bright = kBright * high->open;
    for (const Block& block : blocks)
      if (block.open > bright && block.open > 0 && block.crossed > 0)
        ratios.push_back(std::log(block.crossed / block.open));
  }
  return ratios;
}

double upperMode(std::vector<double>& ratios) {
  const auto decile = ratios.begin() + static_cast<ptrdiff_t>(ratios.size() * 9 / 10);
  std::nth_element(ratios.begin(), decile, ratios.end());
  double at = *decile;
  for (int step = 0; step < kMostSteps; ++step) {
    double sum = 0, weights = 0;
    for (const double ratio : ratios) {
      const double away = (ratio - at) / kWidth;
      const double weight = std::exp(-away * away / 2);
      sum += weight * ratio;
      weights += weight;
    }
    const double next = sum / weights;  // the decile itself is near
    if (std::abs(next - at) < 1e-3 * kWidth) break;
    at = next;
  }
  return at;
}

}  // namespace

CrossedPass crossedPass(const Capture& capture, const CapturePixels& photographs) {
  const LightingMatrix lighting = lightingFromCapture(capture);
  std::vector<Sum> sums;
  for (size_t k = 0; k < capture.shots.size(); ++k)
    for (int c = 0; c < 3 && capture.shots[k].crossed; ++c)
      if (auto sum = sumFor(capture, lighting, k, c)) sums.push_back(std::move(*sum));
  const std::string where = capture.calledName();
  CrossedPass pass;
  std::array<bool, 3> known{};
  size_t fewer = 0, more = 0, all = 0;
  for (int c = 0; c < 3; ++c) {
    std::vector<double> ratios = ratiosOf(photographs, sums, c);
    if (ratios.size() < kFewBlocks) continue;
    const double mode = upperMode(ratios);
    known[static_cast<size_t>(c)] = true;
    pass.part[c] = static_cast<float>(std::exp(mode));
    all += ratios.size();
    for (const double ratio : ratios) {
      fewer += ratio < mode + std::log(kDark);
      more += ratio > mode - std::log(kDark);
    }
  }
  const auto count = static_cast<float>(std::count(known.begin(), known.end(), true));
  if (count == 0)
    throw InputError(
        "{}: what the crossed polarisers leave of the light cannot be told: take each lighting twice, with "
        "the "
        "camera's filter crossed and not, and enough of the picture lit and not clipped.",
        where);
  // A channel of which nothing is known passes what the others do.
  float sum = 0;
  for (int c = 0; c < 3; ++c) sum += known[static_cast<size_t>(c)] ? pass.part[c] : 0;
  for (int c = 0; c < 3; ++c)
    if (!known[static_cast<size_t>(c)]) pass.part[c] = sum / count;
  const double few = kFewHighlights * static_cast<double>(all);
  pass.reversed = (static_cast<double>(more) > few && more > 2 * fewer) || sum / count > kMostPass;
  return pass;
}

}  // namespace swaplight
