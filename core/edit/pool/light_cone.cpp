#include "core/edit/pool/light_cone.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/optim.hpp>

namespace swaplight {
namespace {

constexpr int kNumbers = 6;       // x, y, log of the radii, angle, log of the softness
constexpr double kShadow = 0.25;  // what a dark pixel inside costs, over a lit one outside: there are shadows
constexpr double kRound = 1e-3;   // cost of an ellipse e times as long as wide
constexpr double kSoft = 1e-3;    // cost of a cone that is all edge
constexpr double kLeastGain = 0.5;  // of the cost that one has without a cone
constexpr double kLeastOutside = 0.05;
constexpr double kMostLeak = 0.08;  // mean light outside
constexpr double kLeastFill = 0.6;  // mean light inside

LightCone coneOf(const double* n) {
  const auto size = [](double logarithm) { return std::exp(std::clamp(logarithm, -5., 3.)); };
  return {n[0], n[1], size(n[2]), size(n[3]), std::cos(n[4]), std::sin(n[4]), size(n[5]), {}};
}

class ConeCost : public cv::MinProblemSolver::Function {
 public:
  explicit ConeCost(std::span<const SeenPixel> pixels) : m_pixels(pixels) {}
  [[nodiscard]] int getDims() const override { return kNumbers; }
  double calc(const double* n) const override {
    const double longer = n[2] - n[3];
    const double soft = std::max(n[5], 0.);
    return unexplainedBy(coneOf(n), m_pixels) + kRound * longer * longer + kSoft * soft * soft;
  }

 private:
  std::span<const SeenPixel> m_pixels;
};

// Where to begin: the middle of the light, and twice its standard deviation (which a full disc's radius is).
cv::Mat1d beginning(std::span<const SeenPixel> pixels) {
  double sum = 0;
  double x = 0;
  double y = 0;
  for (const SeenPixel& pixel : pixels) {
    sum += pixel.seen;
    x += pixel.seen * pixel.x;
    y += pixel.seen * pixel.y;
  }
  x /= sum;
  y /= sum;
  double xx = 0;
  double yy = 0;
  for (const SeenPixel& pixel : pixels) {
    xx += pixel.seen * (pixel.x - x) * (pixel.x - x);
    yy += pixel.seen * (pixel.y - y) * (pixel.y - y);
  }
  const auto radius = [&](double moment) { return std::log(2 * std::sqrt(moment / sum) + 1e-3); };
  return (cv::Mat1d(1, kNumbers) << x, y, radius(xx), radius(yy), 0., std::log(0.2));
}

// Whether the cone explains what is dark, rather than a shadow that happens to lie at the border.
bool divides(const LightCone& cone, std::span<const SeenPixel> pixels) {
  double outside = 0;
  double leak = 0;
  double inside = 0;
  double fill = 0;
  for (const SeenPixel& pixel : pixels) {
    const double c = cone.at(pixel.x, pixel.y);
    if (c < 0.1) {
      outside += 1;
      leak += pixel.seen;
    } else if (c > 0.9) {
      inside += 1;
      fill += pixel.seen;
    }
  }
  return outside > kLeastOutside * static_cast<double>(pixels.size()) && leak < kMostLeak * outside &&
         inside > 0 && fill > kLeastFill * inside;
}

}  // namespace

double unexplainedBy(const LightCone& cone, std::span<const SeenPixel> pixels) {
  double cost = 0;
  for (const SeenPixel& pixel : pixels) {
    const double missing = cone.at(pixel.x, pixel.y) - pixel.seen;
    cost += (missing > 0 ? kShadow : 1) * missing * missing;
  }
  return cost / static_cast<double>(pixels.size());
}

cv::Point2d LightCone::middle() const {
  return outline && !outline->isCut() ? outline->middle() : cv::Point2d(x, y);
}

double LightCone::meanRadius() const {
  return outline ? outline->spread() : std::sqrt(radiusA * radiusB);
}

void LightCone::setEdge(double radius) {
  radiusA *= radius;
  radiusB *= radius;
  if (outline) outline->setEdge(radius);
}

double LightCone::radius(double px, double py) const {
  if (outline) return outline->radius(px, py);
  const double a = (cosine * (px - x) + sine * (py - y)) / radiusA;
  const double b = (cosine * (py - y) - sine * (px - x)) / radiusB;
  return std::sqrt(a * a + b * b);
}

double LightCone::atRadius(double radius) const {
  const double t = std::clamp((1 - radius) / softness + 0.5, 0., 1.);
  return t * t * (3 - 2 * t);
}

std::optional<LightCone> findCone(std::span<const SeenPixel> pixels) {
  double seen = 0;
  for (const SeenPixel& pixel : pixels) seen += pixel.seen;
  const double dark = static_cast<double>(pixels.size()) - seen;
  if (!(seen > 0) || dark < kLeastOutside * static_cast<double>(pixels.size())) return std::nullopt;

  const auto cost = cv::makePtr<ConeCost>(pixels);
  const cv::Mat1d steps = (cv::Mat1d(1, kNumbers) << .2, .2, .6, .6, 1., 1.4);
  const auto solver = cv::DownhillSolver::create(
      cost, steps, cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 500, 1e-6));
  cv::Mat found = beginning(pixels);
  const double least = solver->minimize(found);
  double without = 0;
  for (const SeenPixel& pixel : pixels) without += kShadow * (1 - pixel.seen) * (1 - pixel.seen);
  without /= static_cast<double>(pixels.size());
  LightCone cone = coneOf(found.ptr<double>());
  cone.explained = 1 - least / without;
  if (!(cone.explained > kLeastGain) || !divides(cone, pixels)) return std::nullopt;
  return cone;
}

}  // namespace swaplight
