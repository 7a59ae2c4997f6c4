#include "core/solve/calibration/chosen_color.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/capture/capture_pixels.h"
#include "core/capture/no_such_light.h"
#include "core/ocio/luminance.h"
#include "core/solve/calibration/swapped_evening.h"

namespace swaplight {
namespace {

/// The mean signal around a place, in both photographs and evened.
std::array<Rgb, 2> signalAround(const ShotSignal& signal, const SwappedColor& swapped, const Evening& evening,
                                const OpenColorChoice& choice, const std::array<int, 2>& told,
                                const char* what) {
  constexpr int kAround = 2;  // pixels to each side
  const int width = signal.pixels().width(), height = signal.pixels().height();
  const std::array<int, 2> place{told[0] - choice.corner[0], told[1] - choice.corner[1]};
  if (place[0] < 0 || place[1] < 0 || place[0] >= width || place[1] >= height)
    throw InputError("the {} at {},{} lies outside of the picture of {} x {} pixels", what, told[0], told[1],
                     width, height);
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
      throw InputError("the {} at {},{} is black: nothing can be read off it", what, told[0], told[1]);
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

/// 2 beta - 1 of a place, at position 0.
float shareAround(const SwappedColorLine& line, const std::array<Rgb, 2>& light) {
  double products = 0, squares = 0;
  for (int c = 0; c < 3; ++c) {
    products += double(line.direction[c]) * (light[0][c] - light[1][c]) / (light[0][c] + light[1][c]);
    squares += double(line.direction[c]) * line.direction[c];
  }
  return float(products / squares);
}

/// How near the line's colours come to the share of all light that a gel lets through.
class Brightness {
 public:
  Brightness(const Capture& capture, float luminance)
      : m_weights(luminanceWeights(linearSpaceOf(capture.colorSpace))), m_wanted(luminance) {}

  [[nodiscard]] float of(const SwappedColorLine& line, float position) const {
    const Rgb color = line.at(position);
    return m_weights.r * color.r + m_weights.g * color.g + m_weights.b * color.b;
  }
  [[nodiscard]] float error(const SwappedColorLine& line, float position) const {
    return std::abs(std::log(std::max(of(line, position), 1e-6F) / m_wanted));
  }
  [[nodiscard]] float nearest(const SwappedColorLine& line) const {
    return bestPosition([&](float position) { return error(line, position); });
  }
  /// A gel's number is a little off; one that is far off is another gel's.
  void check(const SwappedColorLine& line, float position) const {
    constexpr float kMost = 0.18F;  // of the logarithm: a quarter of a stop
    if (error(line, position) <= kMost) return;
    throw InputError(
        "no colour that the photographs allow lets through {:.0f} % of the light: those allowed let through "
        "{:.0f} to {:.0f} %, or {:.0f} to {:.0f} % with the lamps exchanged",
        100 * m_wanted, 100 * std::min(of(line, 0), of(line, 1)), 100 * std::max(of(line, 0), of(line, 1)),
        100 * std::min(of(line.opposite(), 0), of(line.opposite(), 1)),
        100 * std::max(of(line.opposite(), 0), of(line.opposite(), 1)));
  }

 private:
  Rgb m_weights;
  float m_wanted;
};

}  // namespace

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
        shareAround(line, signalAround(signal, swapped, evening, choice, {x, y}, "place lit by one lamp"));
    // Positive: lit by the lamp that had the known gel in the first photograph.
    if ((share > 0) != (index == swapped.lights[0])) line = line.opposite();
    if (line.most > 1) open.position = std::clamp((std::abs(share) - 1) / (line.most - 1), 0.0F, 1.0F);
    open.by = fmt::format("{} alone lights {},{}", light, x, y);
  } else if (choice.grey) {
    const auto& [x, y] = *choice.grey;
    const auto light = signalAround(signal, swapped, evening, choice, {x, y}, "grey place");
    const auto bestTint = [&](const SwappedColorLine& tried) {
      const float best = bestPosition([&](float p) { return tried.tintOf(p, light[0] + light[1]); });
      return std::pair(tried.tintOf(best, light[0] + light[1]), best);
    };
    const auto here = bestTint(line), there = bestTint(line.opposite());
    if (there.first < here.first) line = line.opposite();
    open.position = std::min(here, there).second;
    open.by = fmt::format("{},{} is grey", x, y);
  } else if (choice.luminance) {
    const Brightness wanted(capture, *choice.luminance);
    const float here = wanted.nearest(line), there = wanted.nearest(line.opposite());
    if (wanted.error(line.opposite(), there) < wanted.error(line, here)) line = line.opposite();
    open.position = wanted.nearest(line);
    wanted.check(line, open.position);
    open.by = fmt::format("it lets through {:.0f} % of the light", 100 * *choice.luminance);
  } else if (choice.position) {
    open.position = *choice.position;
    open.by = fmt::format("position {:.2f} of 0..1 was asked for", *choice.position);
  } else {
    open.settled = false;
    open.position = line.likely;
    open.by = line.bareLamp ? "because a lamp without a gel is among them"
              : found.bareLamp
                  ? "because with the lamps the other way round it is a lamp without a gel"
                  : "as if somewhere in the picture each lamp's shadow were lit by the other lamp alone";
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
            "alone lights (--one-lamp LIGHT=X,Y), a grey one (--grey X,Y), how much light the gel lets "
            "through (--gel-luminance Y), or where between both ends (--open-color 0..1)");
}

}  // namespace swaplight
