#include "core/illumination/illumination.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/illumination/even_light.h"

namespace swaplight {
namespace {

constexpr int kSmallWidth = 128;  // pixels: light that is not a shadow's edge has no detail beyond
constexpr int kRows = 16;

using Rows = std::vector<float*>;

// The even light at each pixel of the small pictures.
std::vector<cv::Mat> evenLights(const EvenLight& even, const SmallLights& small) {
  const cv::Size size = small.sum.size();
  std::vector<cv::Mat> lights;
  for (size_t k = 0; k < small.light.size(); ++k) lights.emplace_back(size, CV_32F);
  for (int y = 0; y < size.height; ++y) {
    std::vector<const float*> in;
    Rows out;
    for (size_t k = 0; k < lights.size(); ++k) {
      in.push_back(small.light[k].ptr<float>(y));
      out.push_back(lights[k].ptr<float>(y));
    }
    even.row(in.data(), smallRow(0, y, size, size), size.width, out.data());
  }
  return lights;
}

void greyRow(const Image& light, int y, float* out) {
  const ImageView in = light.view();
  const float* r = in.row(0, y);
  const float* g = in.row(1, y);
  const float* b = in.row(2, y);
  for (int x = 0; x < in.width; ++x) out[x] = (r[x] + g[x] + b[x]) / 3;
}

void makeRow(const SolvedSet& set, const EvenLight& even, const std::vector<ReliefFilter>& relief,
             const SmallRow& at, int y, const Rows& out) {
  const auto width = static_cast<size_t>(set.width());
  std::vector<float> grey(width * out.size());
  std::vector<const float*> in;
  for (size_t k = 0; k < out.size(); ++k) {
    greyRow(set.contributions[k], y, &grey[k * width]);
    in.push_back(&grey[k * width]);
  }
  even.row(in.data(), at, set.width(), out.data());
  for (size_t k = 0; k < relief.size(); ++k) relief[k].row(at, set.width(), out[k]);
}

}  // namespace

std::vector<Image> illuminationMaps(const SolvedSet& set, const IlluminationOptions& options,
                                    const Progress& progress) {
  progress.update(0, "finding the light on the set");
  const SmallLights small = smallLights(set, kSmallWidth);
  const EvenLight even(small);
  const cv::Size size = small.sum.size();
  std::vector<ReliefFilter> relief;
  if (options.smoothing > 0)
    for (const cv::Mat& light : evenLights(even, small))
      relief.emplace_back(light, std::max(options.smoothing * size.width, 0.1));
  progress.update(0.4F, "finding the light on the set");

  std::vector<Image> maps;
  for (size_t k = 0; k < set.contributions.size(); ++k)
    maps.emplace_back(ImageSpec{set.width(), set.height(), {"Y"}, set.colorSpace()});
  parallelRows(set.height(), kRows, [&](int begin, int end) {
    progress.update(0.4F, "finding the light on the set");
    for (int y = begin; y < end; ++y) {
      Rows out;
      for (Image& map : maps) out.push_back(map.span().row(0, y));
      makeRow(set, even, relief, smallRow(0, y, {set.width(), set.height()}, size), y, out);
    }
  });
  return maps;
}

SolvedSet greySet(const SolvedSet& set, const IlluminationOptions& options, const Progress& progress) {
  SolvedSet grey;
  grey.capture = set.capture;
  grey.carried = set.carried;
  grey.report = set.report;
  for (const Image& map : illuminationMaps(set, options, progress)) {
    Image& light = grey.contributions.emplace_back(ImageSpec::rgb(set.width(), set.height()));
    light.setColorSpace(set.colorSpace());
    for (int c = 0; c < 3; ++c) std::copy_n(map.plane(0), map.pixelCount(), light.plane(c));
  }
  grey.beta = Image(set.beta.spec());
  updateBeta(grey);
  return grey;
}

}  // namespace swaplight
