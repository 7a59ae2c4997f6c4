#include "core/edit/pool/spot_pool.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/edit/pool/light_pool.h"

namespace swaplight {
namespace {

// What a cone has to explain of the dark, to be one. Chosen on ../shared/captures/random and seeds 2001 to
// 2025: the four suns that shine in between things and were taken for spots are below (.667 at most), 22 of
// 25 spots above; on seeds 3101 to 3112 so are the one sun and 10 of 12 spots.
constexpr double kSurely = .7;
constexpr double kPoolFade = .1;  // radii, from nothing to all of it

}  // namespace

std::shared_ptr<const Image> spotPool(const SolvedSet& set, size_t light) {
  if (light >= set.contributions.size()) return nullptr;
  const std::optional<LightCone> cone = measurePool(set, light).cone;
  if (!cone || !(cone->explained > kSurely)) return nullptr;
  const int width = set.width(), height = set.height();
  auto pool = std::make_shared<Image>(ImageSpec{width, height, {"Y"}, "data"});
  const double edge = 1 - .5 * (cone->softness + cone->unsure());
  parallelRows(height, 16, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const double py = (.5 * height - (y + .5)) / width;
      float* row = pool->span().row(0, y);
      for (int x = 0; x < width; ++x) {
        const double radius = cone->radius((x + .5) / width - .5, py);
        row[x] = static_cast<float>(std::clamp((edge - radius) / kPoolFade, 0., 1.));
      }
    }
  });
  return pool;
}

}  // namespace swaplight
