#include "core/solve/calibration/ambient_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/quantile.h"
#include "core/capture/left_out.h"
#include "core/solve/estimators/demultiplex.h"
#include "core/solve/model/pixel_sample.h"
#include "core/solve/model/solved_planes.h"

namespace swaplight {

Capture withAmbientLight(const Capture& capture, const std::string& where) {
  if (capture.ambient)
    throw InputError(
        "{}: has an ambient picture, so there is no ambient light to solve for; do not ask for it "
        "(--solve-ambient)",
        where);
  if (capture.shotCount() <= capture.lightCount())
    throw InputError(
        "{}: to solve for ambient light takes more shots than lights, here {} of {}; photograph one more "
        "(all lights dimmed, or off), or do not ask for it (--solve-ambient)",
        where, capture.shotCount(), capture.lightCount());
  std::vector<Shot> leftOut = leftOutOf(capture);
  Capture all = capture;
  all.lights.push_back({kAmbientLight, Role::Other, Json::object()});
  for (std::vector<Shot>* shots : {&all.shots, &leftOut})
    for (Shot& shot : *shots) shot.lightColors.emplace_back(Rgb(1));
  return withLeftOut(std::move(all), leftOut);
}

Rgb ambientColor(const EstimatorContext& context, const ShotSignal& signal, const AmbientTuning& tuning) {
  const int n = context.lighting.lights;
  const PackedRun sample = pixelSample(signal, context.lighting.shots, size_t(tuning.sample));
  const size_t count = size_t(sample.run().count);
  const SolvedPlanes planes(n, count);
  const SolvedRun& out = planes.run();
  const Demultiplex full(context, Demultiplex::Bound::Clamp);
  full.estimate(sample.run(), out);
  std::array<std::vector<float>, 3> ratios;
  for (size_t p = 0; p < count; ++p) {
    float total = 0;
    for (int i = 0; i < n; ++i)
      for (int c = 0; c < 3; ++c) total += out.contribution[i][c][p] / 3;
    std::array<float, 3> ratio{};
    float mean = 0;
    bool seen = true;
    for (size_t c = 0; c < 3; ++c) {
      float others = 0;
      for (int i = 0; i + 1 < n; ++i) others += out.contribution[i][c][p];
      const float ambient = out.contribution[n - 1][c][p];
      seen = seen && others > tuning.minOthers * total && ambient > tuning.minSignal * out.sigma[p] * total;
      ratio[c] = ambient / std::max(others, tuning.minOthers * total + 1e-20F);
      mean += ratio[c] / 3;
    }
    if (!seen) continue;
    for (size_t c = 0; c < 3; ++c)
      ratios[c].push_back(std::clamp(ratio[c] / mean, 1 / tuning.maxSaturation, tuning.maxSaturation));
  }
  if (ratios[0].size() < size_t(tuning.minPixels)) return Rgb(1);
  Rgb color;
  for (size_t c = 0; c < 3; ++c) color[int(c)] = median(std::span(ratios[c]));
  return 3.0F * color / (color.r + color.g + color.b);
}

void colorAmbient(LightingMatrix& lighting, const Rgb& color) {
  for (int k = 0; k < lighting.shots; ++k) lighting.color(k, lighting.lights - 1) *= color;
}

void takeAmbientOut(const Capture& capture, const Rgb& color, SolvedSet& set) {
  set.capture = capture;
  Image ambient = std::move(set.contributions.back());
  set.contributions.pop_back();
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < ambient.pixelCount(); ++p) ambient.plane(c)[p] *= color[c];
  set.ambient = std::move(ambient);

  ImageSpec spec = set.beta.spec();
  spec.channels.pop_back();
  Image beta(spec);
  const int lights = set.lightCount();
  for (size_t p = 0; p < beta.pixelCount(); ++p) {
    float sum = 0;
    for (int i = 0; i < lights; ++i) sum += set.beta.plane(i)[p];
    for (int i = 0; i < lights; ++i) beta.plane(i)[p] = sum > 0 ? set.beta.plane(i)[p] / sum : 0;
  }
  set.beta = std::move(beta);
}

}  // namespace swaplight
