#include "core/bench/bench_truth.h"

#include "core/base/error.h"
#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"

namespace swaplight {

SolvedSet benchTruth(const Capture& capture) {
  SolvedSet truth;
  truth.capture = capture;
  for (const Light& light : capture.lights) {
    const auto path = capture.truth.find(light.name);
    if (path == capture.truth.end())
      throw InputError("{}: has no truth for light {}; the benchmark needs a capture with \"truth\"",
                       capture.file.string(), light.name);
    truth.contributions.push_back(rgbImage(readImage(capture.folder / path->second).image, path->second));
    const Image &first = truth.contributions.front(), &last = truth.contributions.back();
    if (last.width() != first.width() || last.height() != first.height())
      throw InputError("{}: the truth of light {} is {} x {} pixels, of others {} x {}",
                       capture.file.string(), light.name, last.width(), last.height(), first.width(),
                       first.height());
  }
  for (const Shot& shot : capture.shots)
    for (const auto& color : shot.lightColors)
      if (!color)
        throw InputError("{}: the colour of a light is unknown; the benchmark photographs known ones",
                         capture.file.string());
  updateBeta(truth);
  return truth;
}

SolvedSet benchTruth(const Capture& capture, const std::vector<Image>& contributions) {
  SolvedSet truth;
  truth.capture = capture;
  for (const Image& t : contributions) truth.contributions.push_back(t.clone());
  updateBeta(truth);
  return truth;
}

}  // namespace swaplight
