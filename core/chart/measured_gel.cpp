#include "core/chart/measured_gel.h"

#include <cmath>
#include <glm/common.hpp>

#include "core/base/error.h"

namespace swaplight {

double exposureOver(const ChartShot& shot, const ChartShot& other) {
  if (shot.exposureStops.has_value() != other.exposureStops.has_value())
    throw InputError("{} states its exposure, {} does not: their lights cannot be compared",
                     (shot.exposureStops ? shot : other).file.string(),
                     (shot.exposureStops ? other : shot).file.string());
  return shot.exposureStops ? *shot.exposureStops - *other.exposureStops : 0;
}

Rgb measuredGel(const ChartShot& through, const ChartShot& without) {
  const auto exposure = float(std::exp2(exposureOver(through, without)));
  const Rgb passed = through.fit.light / (without.fit.light * exposure);
  return glm::max(without.fit.matrix ? throughCamera(*without.fit.matrix, passed) : passed, Rgb(0));
}

}  // namespace swaplight
