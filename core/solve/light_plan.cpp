#include "core/solve/light_plan.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace swaplight {
namespace {

constexpr double kSingular = 1e-3;  // of the largest singular value: beyond this a float solve is noise

double distanceOfLights(const LightPlan& plan, int i, int j) {
  double largest = 0;
  for (int k = 0; k < plan.shots; ++k)
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(double(plan.color(k, i)[c]) - plan.color(k, j)[c]));
  return largest;
}

/// Noise of the difference of two lights over the noise of a shot, all channels pooled.
double pairAmplification(const LightPlan& plan, int i, int j) {
  double sum = 0;
  for (int k = 0; k < plan.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const double d = double(plan.color(k, i)[c]) - plan.color(k, j)[c];
      sum += d * d;
    }
  return sum > 0 ? std::sqrt(3.0 * 2.0 / sum) : std::numeric_limits<double>::infinity();
}

}  // namespace

Eigen::MatrixXd LightPlan::matrix(int channel) const {
  Eigen::MatrixXd m(shots, lights);
  for (int k = 0; k < shots; ++k)
    for (int i = 0; i < lights; ++i) m(k, i) = color(k, i)[channel];
  return m;
}

LightPlan planFromCapture(const Capture& capture, std::vector<int>* unknown) {
  LightPlan plan{capture.shotCount(), capture.lightCount(), {}, {}};
  for (const Light& light : capture.lights) plan.names.push_back(light.name);
  for (int k = 0; k < plan.shots; ++k) {
    const Shot& shot = capture.shots[static_cast<size_t>(k)];
    for (int i = 0; i < plan.lights; ++i) {
      const auto& given = shot.lightColors[static_cast<size_t>(i)];
      Rgb color(1, 1, 1);
      if (given) {
        color = *given;
      } else {
        if (unknown) unknown->push_back(k * plan.lights + i);
        Rgb sum(0, 0, 0);
        int count = 0;
        for (const Shot& other : capture.shots)
          if (const auto& known = other.lightColors[static_cast<size_t>(i)]) sum += *known, ++count;
        if (count > 0) color = sum / float(count);
      }
      plan.colors.push_back(color * std::exp2(shot.exposureStops));
    }
  }
  return plan;
}

Conditioning conditioningOf(const LightPlan& plan) {
  Conditioning result;
  double pooled = 0;
  for (int c = 0; c < 3; ++c) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(plan.matrix(c));
    const Eigen::VectorXd s = svd.singularValues();
    auto& values = result.singularValues[size_t(c)];
    values.assign(s.data(), s.data() + s.size());
    values.resize(size_t(plan.lights), 0.0);  // fewer shots than lights: the rest is not seen at all
    const double smallest = values.back();
    const bool singular = smallest < kSingular * values.front() || values.front() == 0;
    double inverse = 0;
    for (double v : values) inverse += v > 0 ? 1 / (v * v) : std::numeric_limits<double>::infinity();
    result.condition[size_t(c)] =
        singular ? std::numeric_limits<double>::infinity() : values.front() / smallest;
    result.amplification[size_t(c)] =
        singular ? std::numeric_limits<double>::infinity() : std::sqrt(inverse / plan.lights);
    if (singular)
      result.advice.push_back(fmt::format(
          "the {} channel alone cannot tell the lights apart: it leans on the other channels", c == 0 ? "red"
                                                                                               : c == 1
                                                                                                   ? "green"
                                                                                                   : "blue"));
  }
  for (int i = 0; i < plan.lights; ++i) {
    for (int j = i + 1; j < plan.lights; ++j) {
      const double pair = pairAmplification(plan, i, j);
      pooled = std::max(pooled, pair);
      if (pair > 6)
        result.advice.push_back(fmt::format(
            "{} and {} are nearly the same colour: the noise of their difference is amplified {:.0f} "
            "times; move {}'s hue away from {}'s",
            plan.names[size_t(i)], plan.names[size_t(j)], pair, plan.names[size_t(j)],
            plan.names[size_t(i)]));
    }
  }
  result.matteAmplification = pooled;
  return result;
}

void checkSolvable(const LightPlan& plan, const std::string& where) {
  if (plan.lights > kMaxLights)
    throw InputError("{}: {} lights; at most {} can be told apart", where, plan.lights, kMaxLights);
  if (plan.shots > kMaxShots)
    throw InputError("{}: {} shots; at most {} are used", where, plan.shots, kMaxShots);
  if (plan.shots * 3 < plan.lights + 2 && plan.lights > 1)
    throw InputError(
        "{}: {} lights are more than {} shot{} x 3 channels can tell apart; photograph at least {} shots",
        where, plan.lights, plan.shots, plan.shots == 1 ? "" : "s", (plan.lights + 4) / 3);
  for (int i = 0; i < plan.lights; ++i) {
    float brightest = 0;
    for (int k = 0; k < plan.shots; ++k)
      for (int c = 0; c < 3; ++c) brightest = std::max(brightest, plan.color(k, i)[c]);
    if (brightest <= 0)
      throw InputError("{}: light {} is off in every shot; give it a colour in one, or remove it", where,
                       plan.names[size_t(i)]);
    for (int j = i + 1; j < plan.lights; ++j)
      if (distanceOfLights(plan, i, j) < 1e-4 * brightest)
        throw InputError(
            "{}: lights {} and {} have the same colour in every shot; change one of them in at least one "
            "shot",
            where, plan.names[size_t(i)], plan.names[size_t(j)]);
  }
}

}  // namespace swaplight
