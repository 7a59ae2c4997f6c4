#include "core/normals/set_surfaces.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/normals/placed_lights.h"
#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/numeric/smooth_fill.h"

namespace swaplight {
namespace {

constexpr int kRowsAtOnce = 32;
constexpr int kContinuedSize = 480;  // pixels of the longer side: what is continued is smooth
constexpr float kPictureEdge = .3F;  // of the logarithm: by a third brighter is another surface
constexpr float kLeastLight = 1e-4F;

cv::Mat rgbAtUnitWhite(const SolvedSet& set) {
  const Image sum = sumAtUnitWhite(set);
  cv::Mat rgb;
  cv::merge(std::vector<cv::Mat>{planeOf(sum, 0), planeOf(sum, 1), planeOf(sum, 2)}, rgb);
  return rgb;
}

/// What is smooth in the surfaces, known in most places, continued into the others; small.
struct Continued {
  cv::Mat normal[3];
  cv::Mat logLight;  ///< of all lamps together on a surface, as it is turned
};

Continued continuedFrom(const SurfaceNormals& found, const cv::Mat& white, const cv::Mat& known) {
  const cv::Size size = sizeWithin(white.size(), kContinuedSize);
  cv::Mat light = cv::max(greyOf(white), kLeastLight);
  cv::Mat reflectance(white.size(), CV_32F, cv::Scalar(0));
  for (int c = 0; c < 3; ++c) reflectance += planeOf(found.reflectance, c) / 3;
  cv::divide(light, cv::max(reflectance, kLeastLight), light);
  cv::log(light, light);
  const cv::Mat fixed = shrunk(known, size) > .25;
  const SmoothFill fill(fixed, guideOf(shrunk(white, size)), kPictureEdge);
  Continued continued;
  for (int c = 0; c < 3; ++c) continued.normal[c] = fill.of(meanOver(planeOf(found.normals, c), known, size));
  continued.logLight = fill.of(meanOver(light, known, size));
  return continued;
}

void fillRefused(const Continued& continued, const cv::Mat& white, SetSurfaces& surfaces) {
  const cv::Size full = white.size();
  const cv::Mat normal[3] = {grown(continued.normal[0], full), grown(continued.normal[1], full),
                             grown(continued.normal[2], full)};
  const cv::Mat light = grown(continued.logLight, full);
  parallelRows(full.height, kRowsAtOnce, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < full.width; ++x) {
        const size_t pixel =
            static_cast<size_t>(y) * static_cast<size_t>(full.width) + static_cast<size_t>(x);
        if (!surfaces.guessed[pixel]) continue;
        const cv::Vec3f mean(normal[0].at<float>(y, x), normal[1].at<float>(y, x), normal[2].at<float>(y, x));
        const double length = cv::norm(mean);
        constexpr double kOpposed = .1;  // normals around that point in all directions tell none
        const cv::Vec3f turned = length > kOpposed ? mean / length : cv::Vec3f(0, 0, 1);
        const cv::Vec3f paint = white.at<cv::Vec3f>(y, x) / std::exp(light.at<float>(y, x));
        for (int c = 0; c < 3; ++c) {
          surfaces.normals.plane(c)[pixel] = turned[c];
          surfaces.reflectance.plane(c)[pixel] = std::max(paint[c], 0.F);
        }
      }
  });
}

}  // namespace

const LeveledLight* SetSurfaces::lampOf(size_t light) const {
  const auto found =
      std::find_if(lamps.begin(), lamps.end(), [&](const LeveledLight& lamp) { return lamp.light == light; });
  return found == lamps.end() ? nullptr : &*found;
}

SetSurfaces setSurfaces(const SolvedSet& set, const SurfaceNormals& found) {
  SetSurfaces surfaces;
  surfaces.normals = found.normals.clone();
  surfaces.reflectance = found.reflectance.clone();
  surfaces.lamps = found.lamps;
  surfaces.level = 0;
  for (const LeveledLight& lamp : found.lamps) surfaces.level = std::max(surfaces.level, lamp.level);
  const size_t pixels = found.normals.pixelCount();
  surfaces.guessed.resize(pixels);
  cv::Mat known(set.height(), set.width(), CV_32F);
  const auto isKnown = [&](size_t p) { return found.normals.plane(2)[p] > 0; };
  for (size_t p = 0; p < pixels; ++p) {
    surfaces.guessed[p] = isKnown(p) ? 0 : 1;
    surfaces.guessedShare += surfaces.guessed[p];
    known.ptr<float>()[p] = isKnown(p) ? 1.F : 0.F;
  }
  surfaces.guessedShare /= static_cast<double>(pixels);
  if (surfaces.guessedShare > 0) {
    const cv::Mat white = rgbAtUnitWhite(set);
    fillRefused(continuedFrom(found, white, known), white, surfaces);
  }
  return surfaces;
}

SurfaceSource surfaceSource(std::shared_ptr<const SolvedSet> set, ShadowSource shadows, LampPlaces places) {
  auto kept = std::make_shared<std::shared_ptr<const SetSurfaces>>();
  return [set = std::move(set), shadows = std::move(shadows), places = std::move(places), kept] {
    if (!*kept) {
      const PlacedLights placed = placedLights(places, set->capture, "the lamps' places");
      *kept =
          std::make_shared<const SetSurfaces>(setSurfaces(*set, surfaceNormals(*set, shadows, placed.lamps)));
    }
    return *kept;
  };
}

}  // namespace swaplight
