#include "core/solve/calibration/swapped_color.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/quantile.h"
#include "core/capture/no_such_light.h"
#include "core/linear/decompositions.h"
#include "core/solve/model/pixel_sample.h"

namespace swaplight {
namespace {

using Vector3 = Eigen::Vector3d;

constexpr double kMedianOfChi2 = 0.69;  // of two degrees of freedom, over their mean

/// A few pixels: (y1 - y2) / (y1 + y2) a channel, and its variance.
struct Contrast {
  Vector3 value;
  Vector3 precision;  ///< by noise, and by what no noise explains
};

/// One factor of rank one, and how well the contrasts are explained.
struct RankOne {
  Vector3 direction;
  std::vector<double> share;  ///< 2 beta - 1 over the scale
  std::vector<double> error;  ///< of it, by what the fit leaves in the other directions
};

/// What the two photographs are multiplied by, a channel, to be of one exposure and under lamps of one white.
/// With u^2 = l1 / l2 of the known gel in either lamp, y2 u is y2 under two lamps of the geometric mean.
struct Evening {
  std::array<Rgb, 2> factor;
  Rgb known{1};
  Evening(const Capture& capture, const SwappedColor& swapped) {
    std::array<Rgb, 2> given;
    for (size_t j = 0; j < 2; ++j) {
      const Shot& shot = capture.shots[size_t(swapped.shots[j])];
      given[j] = *shot.lightColors[size_t(swapped.lights[j])];
      factor[j] = Rgb(std::exp2(-shot.exposureStops));
    }
    for (int c = 0; c < 3; ++c) {
      known[c] = std::sqrt(given[0][c] * given[1][c]);
      factor[1][c] *= std::sqrt(given[0][c] / given[1][c]);
    }
  }
};

/// The contrast of a group of pixels; nothing where noise hides it.
std::optional<Contrast> contrastOf(const std::array<Rgb, 2>& mean, int count, const Evening& evening,
                                   const NoiseModel& noise, const SwappedColorTuning& tuning) {
  Contrast contrast;
  for (int c = 0; c < 3; ++c) {
    double y[2], variance[2];
    for (size_t j = 0; j < 2; ++j) {
      const double f = evening.factor[j][c];
      y[j] = f * mean[j][c];
      variance[j] = f * f * noise.variance(mean[j][c]) / count;
    }
    const double sum = y[0] + y[1];
    if (!(sum > tuning.minSignal * std::sqrt(variance[0] + variance[1])) || y[0] <= 0 || y[1] <= 0)
      return std::nullopt;
    contrast.value[c] = (y[0] - y[1]) / sum;
    const double noiseOfIt = 4 * (y[0] * y[0] * variance[1] + y[1] * y[1] * variance[0]) / std::pow(sum, 4);
    contrast.precision[c] = 1 / (noiseOfIt + tuning.systematic * tuning.systematic);
  }
  return contrast;
}

std::vector<Contrast> contrastsOf(const ShotSignal& signal, const SwappedColor& swapped, int shots,
                                  const Evening& evening, const NoiseModel& noise,
                                  const SwappedColorTuning& tuning) {
  const PackedRun sample = pixelSample(signal, shots, size_t(tuning.sample));
  const PixelRun& run = sample.run();
  std::vector<Contrast> contrasts;
  for (int first = 0; first + tuning.together <= run.count; first += tuning.together) {
    std::array<Rgb, 2> mean{Rgb(0), Rgb(0)};
    for (size_t j = 0; j < 2; ++j)
      for (int c = 0; c < 3; ++c)
        for (int p = first; p < first + tuning.together; ++p)
          mean[j][c] += run.signal[swapped.shots[j]][c][p] / float(tuning.together);
    if (const auto contrast = contrastOf(mean, tuning.together, evening, noise, tuning))
      contrasts.push_back(*contrast);
  }
  return contrasts;
}

double shareOf(const Contrast& contrast, const Vector3& direction) {
  const Vector3 weighted = direction.cwiseProduct(contrast.precision);
  return weighted.dot(contrast.value) / weighted.dot(direction);
}

/// Alternates between both factors; what does not fit (glossy, moved) counts less: 1 / (1 + chi-square)^2.
RankOne rankOneOf(const std::vector<Contrast>& contrasts, int rounds) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Contrast& contrast : contrasts)
    moments += contrast.precision.mean() * contrast.value * contrast.value.transpose();
  RankOne fit;
  fit.direction = symmetricEigen(moments).vectors.col(2);
  std::vector<double> chi(contrasts.size()), sorted;
  double typical = 1;
  for (int round = 0; round < rounds; ++round) {
    for (size_t j = 0; j < contrasts.size(); ++j) {
      const Vector3 left = contrasts[j].value - shareOf(contrasts[j], fit.direction) * fit.direction;
      chi[j] = left.cwiseAbs2().dot(contrasts[j].precision) / 2;
    }
    sorted = chi;
    typical = std::max(median(std::span(sorted)) / kMedianOfChi2, 1e-9);
    Vector3 products = Vector3::Zero(), squares = Vector3::Constant(1e-30);
    for (size_t j = 0; j < contrasts.size(); ++j) {
      const double share = shareOf(contrasts[j], fit.direction);
      const double weight = 1 / std::pow(1 + chi[j] / typical, 2);
      products += weight * share * contrasts[j].precision.cwiseProduct(contrasts[j].value);
      squares += weight * share * share * contrasts[j].precision;
    }
    fit.direction = products.cwiseQuotient(squares).normalized();
  }
  for (const Contrast& contrast : contrasts) {
    fit.share.push_back(shareOf(contrast, fit.direction));
    fit.error.push_back(std::sqrt(typical / fit.direction.cwiseAbs2().dot(contrast.precision)));
  }
  return fit;
}

/// The scale of d at which the pixels farthest from evenly lit, noise allowed for, are lit by one lamp.
double smallestScale(const RankOne& fit, const SwappedColorTuning& tuning) {
  std::vector<double> sure;
  for (size_t j = 0; j < fit.share.size(); ++j)
    sure.push_back(std::abs(fit.share[j]) - tuning.deviations * fit.error[j]);
  return quantile(std::span(sure), tuning.extreme);
}

/// The mean signal around a place, in both photographs and evened.
std::array<Rgb, 2> signalAround(const ShotSignal& signal, const SwappedColor& swapped, const Evening& evening,
                                const std::array<int, 2>& place, const char* what) {
  constexpr int kAround = 2;  // pixels to each side
  const int width = signal.pixels().width(), height = signal.pixels().height();
  if (place[0] < 0 || place[1] < 0 || place[0] >= width || place[1] >= height)
    throw InputError("the {} at {},{} lies outside of the picture of {} x {} pixels", what, place[0],
                     place[1], width, height);
  std::array<Rgb, 2> sum{Rgb(0), Rgb(0)};
  std::vector<float> room;
  const int left = std::max(place[0] - kAround, 0), right = std::min(place[0] + kAround + 1, width);
  for (int y = std::max(place[1] - kAround, 0); y < std::min(place[1] + kAround + 1, height); ++y) {
    PixelRun run;
    signal.run(size_t(y) * size_t(width) + size_t(left), right - left, false, room, run);
    for (size_t j = 0; j < 2; ++j)
      for (int c = 0; c < 3; ++c)
        for (int p = 0; p < run.count; ++p)
          sum[j][c] += evening.factor[j][c] * run.signal[swapped.shots[j]][c][p];
  }
  for (const Rgb& light : sum)
    if (!(std::min({light.r, light.g, light.b}) > 0))
      throw InputError("the {} at {},{} is black: nothing can be read off it", what, place[0], place[1]);
  return sum;
}

/// The position of the least value of a function of it.
template <typename Cost>
float bestPosition(const Cost& cost) {
  constexpr int kSteps = 1000;
  float best = 0;
  double least = INFINITY;
  for (int step = 0; step <= kSteps; ++step)
    if (const double value = cost(float(step) / kSteps); value < least)
      least = value, best = float(step) / kSteps;
  return best;
}

/// How far a surface would be from grey that shows this light in both photographs together: its reflectance
/// is (y1 + y2) / (l + m).
double tintOf(const SwappedColorLine& line, float position, const Rgb& light) {
  const Rgb reflectance = light / (line.known + line.at(position));
  const double mean = std::log(std::max(double(reflectance.r) * reflectance.g * reflectance.b, 1e-30)) / 3;
  double spread = 0;
  for (int c = 0; c < 3; ++c) spread += std::pow(std::log(std::max(double(reflectance[c]), 1e-10)) - mean, 2);
  return spread;
}

/// 2 beta - 1 of a place, at position 0.
float shareAround(const SwappedColorLine& line, const std::array<Rgb, 2>& light) {
  double products = 0, squares = 0;
  for (int c = 0; c < 3; ++c) {
    products += double(line.direction[c]) * (light[0][c] - light[1][c]) / (light[0][c] + light[1][c]);
    squares += double(line.direction[c]) * line.direction[c];
  }
  return float(products / squares);
}

/// Of the two directions the one of a colour that a gel can have, which lets through no more than all light;
/// where both are, the one under which the set is nearer to grey on the whole.
SwappedColorLine likelier(const SwappedColorLine& line, const Rgb& light) {
  constexpr float kMost = 1.05F;  // of full light: a gel's number is a little off
  const SwappedColorLine other = line.opposite();
  const auto possible = [](const Rgb& color) { return std::max({color.r, color.g, color.b}) <= kMost; };
  if (possible(line.at(0)) != possible(other.at(0))) return possible(line.at(0)) ? line : other;
  return tintOf(line, 0, light) <= tintOf(other, 0, light) ? line : other;
}

}  // namespace

SwappedColorLine SwappedColorLine::opposite() const {
  return {known, -direction, most};
}

Rgb SwappedColorLine::at(float position) const {
  const Rgb d = (1 + std::clamp(position, 0.0F, 1.0F) * (most - 1)) * direction;
  return known * (Rgb(1) - d) / (Rgb(1) + d);
}

SwappedColorLine swappedColorLine(const Capture& capture, const SwappedColor& swapped,
                                  const ShotSignal& signal, const NoiseModel& noise,
                                  const SwappedColorTuning& tuning) {
  const Evening evening(capture, swapped);
  const std::vector<Contrast> contrasts =
      contrastsOf(signal, swapped, capture.shotCount(), evening, noise, tuning);
  if (contrasts.size() < size_t(tuning.minGroups))
    throw InputError(
        "an unknown colour cannot be estimated: hardly a pixel is bright enough and not clipped in both "
        "photographs; tell the colour");
  const RankOne fit = rankOneOf(contrasts, tuning.rounds);
  SwappedColorLine line;
  line.known = evening.known;
  const double widest = fit.direction.cwiseAbs().maxCoeff();
  const double scale = std::min(smallestScale(fit, tuning), tuning.farthest / widest);
  if (!(scale * widest > tuning.minContrast))
    throw InputError(
        "an unknown colour cannot be estimated: photographs {} and {} do not differ; did the lamps exchange "
        "their gels?",
        swapped.shots[0] + 1, swapped.shots[1] + 1);
  for (int c = 0; c < 3; ++c) line.direction[c] = float(scale * fit.direction[c]);
  line.most = float(tuning.farthest / (scale * widest));
  const std::vector<Rgb> mean = signal.meanSignal();
  return likelier(line, evening.factor[0] * mean[size_t(swapped.shots[0])] +
                            evening.factor[1] * mean[size_t(swapped.shots[1])]);
}

OpenColor chosenColor(const Capture& capture, const SwappedColor& swapped, const ShotSignal& signal,
                      const SwappedColorLine& found, const OpenColorChoice& choice) {
  const Evening evening(capture, swapped);
  SwappedColorLine line = choice.exchanged ? found.opposite() : found;
  OpenColor open;
  open.settled = true;
  if (choice.oneLamp) {
    const auto& [light, x, y] = *choice.oneLamp;
    const auto index = static_cast<int>(placeOfLight(capture, light, "the place that one lamp alone lights"));
    const float share =
        shareAround(line, signalAround(signal, swapped, evening, {x, y}, "place lit by one lamp"));
    // Positive: lit by the lamp that had the known gel in the first photograph.
    if ((share > 0) != (index == swapped.lights[0])) line = line.opposite();
    if (line.most > 1) open.position = std::clamp((std::abs(share) - 1) / (line.most - 1), 0.0F, 1.0F);
    open.by = fmt::format("{} alone lights {},{}", light, x, y);
  } else if (choice.grey) {
    const auto& [x, y] = *choice.grey;
    const auto light = signalAround(signal, swapped, evening, {x, y}, "grey place");
    const auto bestTint = [&](const SwappedColorLine& tried) {
      const float best = bestPosition([&](float p) { return tintOf(tried, p, light[0] + light[1]); });
      return std::pair(tintOf(tried, best, light[0] + light[1]), best);
    };
    const auto here = bestTint(line), there = bestTint(line.opposite());
    if (there.first < here.first) line = line.opposite();
    open.position = std::min(here, there).second;
    open.by = fmt::format("{},{} is grey", x, y);
  } else if (choice.position) {
    open.position = *choice.position;
    open.by = fmt::format("position {:.2f} of 0..1 was asked for", *choice.position);
  } else {
    open.settled = false;
    open.by = "as if somewhere in the picture each lamp's shadow were lit by the other lamp alone";
  }
  open.nearest = line.at(0);
  open.farthest = line.at(1);
  open.taken = line.at(open.position);
  open.exchanged = line.opposite().at(open.position);
  return open;
}

std::string wordsFor(const OpenColor& open) {
  const auto text = [](const Rgb& color) {
    return fmt::format("{:.3f}/{:.3f}/{:.3f}", color.r, color.g, color.b);
  };
  const auto warmth = [](const Rgb& color) { return color.r / std::max(color.b, 1e-6F); };
  const bool warmer = warmth(open.farthest) > warmth(open.nearest);
  return fmt::format(
      "{}: two photographs leave one number of this colour open. From {} ({}) to {} ({}) all of them fit "
      "equally well, and so would {} with the lamps exchanged. Taken: {}, {}.{}",
      open.name, text(open.nearest), warmer ? "cooler" : "warmer", text(open.farthest),
      warmer ? "warmer" : "cooler", text(open.exchanged), text(open.taken), open.by,
      open.settled
          ? ""
          : " What settles it: a third photograph under other colours; or tell a place that one lamp "
            "alone lights (--one-lamp LIGHT=X,Y), a grey one (--grey X,Y), or where between both ends "
            "(--open-color 0..1)");
}

}  // namespace swaplight
