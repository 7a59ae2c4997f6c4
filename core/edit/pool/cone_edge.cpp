#include "core/edit/pool/cone_edge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/quantile.h"

namespace swaplight {
namespace {

constexpr int kEdgeWidth = 160;   // of the small pictures that a cone's edge is measured in
constexpr double kBenefit = 1.1;  // of the doubt, for a cone's edge as it is seen

std::vector<SeenPixel> pixelsOf(const cv::Mat& seen) {
  return gridOf<SeenPixel>(seen.size(), [&](const PicturePlace& place, int y, int x) {
    return SeenPixel{place.x, place.y, seen.at<float>(y, x)};
  });
}

// The outline that is seen, if that tells better what is lit than an ellipse does.
LightCone asSeen(const LightCone& ellipse, const cv::Mat& seen) {
  const std::vector<SeenPixel> pixels = pixelsOf(seen);
  LightCone outlined = ellipse, best = ellipse;
  outlined.outline = ConeOutline::in(seen);
  if (!outlined.outline) return ellipse;
  double least = kBenefit * unexplainedBy(ellipse, pixels);
  for (const double softness : {.05, .1, .2, .4, .8}) {
    outlined.softness = softness;
    const double cost = unexplainedBy(outlined, pixels);
    if (cost < least) {
      least = cost;
      best = outlined;
    }
  }
  return best;
}

// The light's ratio to the others along the cone's radius: 1 inside, 0 far outside. Shadows lie in it, so
// that of a ring the upper quartile counts. NaN where there are too few pixels.
class ConeProfile {
 public:
  ConeProfile(const SmallLight& small, const LightCone& cone) {
    cv::Mat ratio = small.logRatio(small.ownGrey, small.othersGrey);
    for (int y = 0; y < ratio.rows; ++y)
      for (int x = 0; x < ratio.cols; ++x) {
        const PicturePlace place = placeOf(x, y, ratio.size());
        m_pixels.push_back({cone.radius(place.x, place.y), ratio.at<float>(y, x)});
      }
    std::vector<double> inside = between(0, kInside);
    m_inside = inside.size() < kFewest ? 0 : quantile(std::span(inside), 0.6);
    std::vector<double> outside = between(kOutside, 1e9);
    m_outside = outside.size() < kFewest
                    ? 0
                    : std::min(std::exp(quantile(std::span(outside), 0.5) - m_inside), kMostBounce);
  }
  [[nodiscard]] double at(double radius) const {
    std::vector<double> ring = between(radius - kRing, radius + kRing);
    if (ring.size() < kFewest) return std::nan("");
    return (std::exp(quantile(std::span(ring), 0.75) - m_inside) - m_outside) / (1 - m_outside);
  }

 private:
  static constexpr double kInside = 0.7, kOutside = 1.4, kRing = 0.05;  // radii
  static constexpr size_t kFewest = 6;
  struct AtRadius {
    double radius, logRatio;
  };
  [[nodiscard]] std::vector<double> between(double least, double most) const {
    std::vector<double> found;
    for (const AtRadius& pixel : m_pixels)
      if (pixel.radius >= least && pixel.radius < most) found.push_back(pixel.logRatio);
    return found;
  }
  std::vector<AtRadius> m_pixels;
  double m_inside = 0, m_outside = 0;
};

// A cone that was found by where there is any light at all, with its edge where half of the light is, as soft
// as it is.
LightCone withEdge(LightCone cone, const SmallLight& small) {
  constexpr double kFrom = 0.5;
  constexpr double kTo = 1.65;
  constexpr double kStep = 0.05;
  constexpr double kQuarters =
      0.348;  // of a smooth step's width lie between a quarter and three quarters of it
  const ConeProfile profile(small, cone);
  double full = 0;
  for (double r = kFrom; r < kTo; r += kStep)
    if (profile.at(r) >= 0.75) full = r;
  if (full == 0) return cone;
  for (double r = full + kStep; r < kTo; r += kStep)
    if (profile.at(r) <= 0.25) {
      const double edge = .5 * (full + r);
      cone.softness = std::clamp((r - full) / kQuarters / edge, 0.05, 1.);
      cone.setEdge(edge);
      break;
    }
  return cone;
}

}  // namespace

std::optional<LightCone> coneOf(const SolvedSet& set, size_t light, const SmallLight& small) {
  const std::optional<LightCone> found = findCone(pixelsOf(small.lit()));
  if (!found) return found;
  const SmallLight edges = smallLight(set, light, kEdgeWidth);
  return withEdge(asSeen(*found, edges.lit()), edges);
}

}  // namespace swaplight
