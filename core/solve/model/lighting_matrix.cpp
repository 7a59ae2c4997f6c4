#include "core/solve/model/lighting_matrix.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr double kSingular = 1e-3;  // of the largest singular value: beyond this a float solve is noise
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSame = 1e-4;     // of the lights' brightness
constexpr double kDistinct = 0.3;  // colours this far apart, of their brightness, have different hues

double distanceOfLights(const LightingMatrix& lighting, int i, int j) {
  double largest = 0;
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(double(lighting.color(k, i)[c]) - lighting.color(k, j)[c]));
  return largest;
}

constexpr double kNoisy = 6;  // amplification that is worth a word
constexpr std::array<const char*, 3> kChannelNames{"red", "green", "blue"};

/// Noise of the difference of two lights over the noise of a shot, all channels pooled.
double pairAmplification(const LightingMatrix& lighting, int i, int j) {
  double sum = 0;
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const double d = double(lighting.color(k, i)[c]) - lighting.color(k, j)[c];
      sum += d * d;
    }
  return sum > 0 ? std::sqrt(3.0 * 2.0 / sum) : kInfinity;
}

/// The length of a light's colours in all shots.
double brightnessOf(const LightingMatrix& lighting, int light) {
  double sum = 0;
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) sum += double(lighting.color(k, light)[c]) * lighting.color(k, light)[c];
  return std::sqrt(sum);
}

/// What is wrong with two lights, or "".
std::string pairAdvice(const LightingMatrix& lighting, int i, int j) {
  const std::string& a = lighting.names[size_t(i)];
  const std::string& b = lighting.names[size_t(j)];
  const double pair = pairAmplification(lighting, i, j);
  if (pair <= kNoisy) return "";
  const double brightness = brightnessOf(lighting, i) + brightnessOf(lighting, j);
  const double apart = std::sqrt(6.0) / pair;
  if (distanceOfLights(lighting, i, j) < kSame * brightness)
    return fmt::format(
        "{} and {} have the same colour in every photograph and cannot be separated; move {}'s hue away from "
        "{}'s in at least one",
        a, b, b, a);
  if (apart > kDistinct * brightness)
    return fmt::format(
        "{} and {} are both dim: the noise of their difference is amplified {:.0f} times; use brighter "
        "colours, or "
        "expose longer",
        a, b, pair);
  return fmt::format(
      "{} and {} are nearly the same colour: the noise of their difference is amplified {:.0f} times; move "
      "{}'s "
      "hue away from {}'s",
      a, b, pair, b, a);
}

/// Of channels that do not separate the lights; `dark`: those that no light has.
void addChannelAdvice(const std::vector<const char*>& dark, const std::vector<const char*>& singular,
                      std::vector<std::string>& advice) {
  for (const char* channel : dark)
    advice.push_back(fmt::format("no light has {}: the set's {} is not recorded", channel, channel));
  if (singular.size() == 1)
    advice.push_back(fmt::format("the {} channel alone cannot separate the lights{}", singular.front(),
                                 dark.empty() ? ": it relies on the other channels" : ""));
  if (singular.size() == 2)
    advice.push_back(fmt::format("neither the {} nor the {} channel alone can separate the lights{}",
                                 singular[0], singular[1],
                                 dark.empty() ? ": they rely on the other one" : ""));
  if (singular.size() == 3)
    advice.emplace_back(
        "no channel alone can separate the lights: they can be told apart on matte surfaces only, by all "
        "three together");
}

/// The lights of a mixture that the shots hardly see, where it is no pair: "key + back against fill".
std::string mixtureText(const LightingMatrix& lighting, const Eigen::VectorXd& mixture) {
  std::array<std::vector<std::string>, 2> sides;
  const double largest = mixture.cwiseAbs().maxCoeff();
  double first = 0;
  for (int i = 0; i < lighting.lights; ++i) {
    if (std::abs(mixture[i]) <= 0.3 * largest) continue;
    if (first == 0) first = mixture[i];
    sides[first * mixture[i] < 0 ? 1 : 0].push_back(lighting.names[size_t(i)]);
  }
  return sides[1].empty()
             ? fmt::format("{}", fmt::join(sides[0], " + "))
             : fmt::format("{} against {}", fmt::join(sides[0], " + "), fmt::join(sides[1], " + "));
}

}  // namespace

Eigen::MatrixXd LightingMatrix::matrix(int channel) const {
  Eigen::MatrixXd m(shots, lights);
  for (int k = 0; k < shots; ++k)
    for (int i = 0; i < lights; ++i) m(k, i) = color(k, i)[channel];
  return m;
}

namespace {

/// Where the estimate of an unknown colour starts: the mean of what its lights are known to have elsewhere.
Rgb startOfUnknown(const Capture& capture, const std::string& name, size_t light) {
  Rgb sum(0);
  int count = 0;
  for (size_t i = 0; i < capture.lights.size(); ++i) {
    bool has = i == light;
    for (const Shot& shot : capture.shots) has = has || (!name.empty() && shot.colorName(i) == name);
    for (const Shot& shot : capture.shots)
      if (has && shot.lightColors[i]) sum += *shot.lightColors[i], ++count;
  }
  return count > 0 ? sum / float(count) : Rgb(1);
}

}  // namespace

LightingMatrix lightingFromCapture(const Capture& capture) {
  LightingMatrix lighting{capture.shotCount(), capture.lightCount(), {}, {}};
  for (const Light& light : capture.lights) lighting.names.push_back(light.name);
  for (int k = 0; k < lighting.shots; ++k) {
    const Shot& shot = capture.shots[static_cast<size_t>(k)];
    for (int i = 0; i < lighting.lights; ++i) {
      const auto& given = shot.lightColors[static_cast<size_t>(i)];
      const Rgb color = given ? *given : startOfUnknown(capture, shot.colorName(size_t(i)), size_t(i));
      lighting.colors.push_back(color * std::exp2(shot.exposureStops));
    }
  }
  return lighting;
}

Conditioning conditioningOf(const LightingMatrix& lighting) {
  Conditioning result;
  std::vector<const char*> dark, without;  // channels
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(lighting.lights, lighting.lights);
  for (int c = 0; c < 3; ++c) {
    const Eigen::MatrixXd matrix = lighting.matrix(c);
    gram += matrix.transpose() * matrix;
    const Eigen::VectorXd s = singularValues(matrix).values;
    auto& values = result.singularValues[size_t(c)];
    values.assign(s.data(), s.data() + s.size());
    values.resize(size_t(lighting.lights), 0.0);  // fewer shots than lights: the rest is not seen at all
    const double smallest = values.back();
    const bool singular = smallest < kSingular * values.front() || values.front() == 0;
    double inverse = 0;
    for (double v : values) inverse += v > 0 ? 1 / (v * v) : kInfinity;
    result.condition[size_t(c)] = singular ? kInfinity : values.front() / smallest;
    result.amplification[size_t(c)] = singular ? kInfinity : std::sqrt(inverse / lighting.lights);
    if (singular) (values.front() > 0 ? without : dark).push_back(kChannelNames[size_t(c)]);
  }
  addChannelAdvice(dark, without, result.advice);
  const size_t channelAdvices = result.advice.size();
  for (int i = 0; i < lighting.lights; ++i) {
    if (brightnessOf(lighting, i) == 0)
      result.advice.push_back(
          fmt::format("{} is off in every photograph: give it a colour in one", lighting.names[size_t(i)]));
    for (int j = i + 1; j < lighting.lights; ++j)
      if (const std::string advice = pairAdvice(lighting, i, j); !advice.empty())
        result.advice.push_back(advice);
  }

  // A neutral surface has the same contribution in all channels: their Gram matrices add up.
  const SymmetricEigen eigen = symmetricEigen(gram);
  const Eigen::VectorXd& squares = eigen.values;
  const bool singular = !(squares[0] > kSingular * kSingular * squares[lighting.lights - 1]);
  result.matteAmplification = singular ? kInfinity : std::sqrt(squares.cwiseInverse().mean());
  if (result.advice.size() == channelAdvices && (singular || squares[0] < 1 / (kNoisy * kNoisy)))
    result.advice.push_back(fmt::format(
        "the photographs hardly separate {}: {}; change these lights' colours in at least one photograph",
        mixtureText(lighting, eigen.vectors.col(0)),
        singular
            ? "they cannot be separated"
            : fmt::format("the noise of this mixture is amplified {:.0f} times", 1 / std::sqrt(squares[0]))));
  return result;
}

void checkSolvable(const LightingMatrix& lighting, const std::string& where,
                   const std::vector<int>& unknown) {
  const auto differByAnUnknown = [&](int i, int j) {
    for (int k = 0; k < lighting.shots && !unknown.empty(); ++k)
      if (unknown[size_t(k * lighting.lights + i)] != unknown[size_t(k * lighting.lights + j)]) return true;
    return false;
  };
  // Each of its colours is unknown, and stands nowhere else.
  const auto nothingIsKnown = [&](int i) {
    for (int k = 0; k < lighting.shots; ++k) {
      const int here = unknown.empty() ? -1 : unknown[size_t(k * lighting.lights + i)];
      if (here < 0 || std::count(unknown.begin(), unknown.end(), here) > 1) return false;
    }
    return true;
  };
  if (lighting.lights > kMaxLights)
    throw InputError("{}: {} lights; at most {} can be separated", where, lighting.lights, kMaxLights);
  if (lighting.shots > kMaxShots)
    throw InputError("{}: {} shots; at most {} are used", where, lighting.shots, kMaxShots);
  if (lighting.shots * 3 < lighting.lights + 2 && lighting.lights > 1)
    throw InputError(
        "{}: {} lights are more than {} shot{} x 3 channels can separate; take at least {} shots", where,
        lighting.lights, lighting.shots, lighting.shots == 1 ? "" : "s", (lighting.lights + 4) / 3);
  for (int i = 0; i < lighting.lights; ++i) {
    float brightest = 0;
    for (int k = 0; k < lighting.shots; ++k)
      for (int c = 0; c < 3; ++c) brightest = std::max(brightest, lighting.color(k, i)[c]);
    if (brightest <= 0)
      throw InputError("{}: light {} is off in every shot; give it a colour in one, or remove it", where,
                       lighting.names[size_t(i)]);
    for (int j = i + 1; j < lighting.lights; ++j)
      if (nothingIsKnown(i) && nothingIsKnown(j))
        throw InputError(
            "{}: the colours of {} and {} are unknown in every shot; tell at least one of them, or give what "
            "is "
            "the same gel one name",
            where, lighting.names[size_t(i)], lighting.names[size_t(j)]);
      else if (!differByAnUnknown(i, j) && distanceOfLights(lighting, i, j) < 1e-4 * brightest)
        throw InputError(
            "{}: lights {} and {} have the same colour in every shot; change one of them in at least one "
            "shot",
            where, lighting.names[size_t(i)], lighting.names[size_t(j)]);
  }
}

}  // namespace swaplight
