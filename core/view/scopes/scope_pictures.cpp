#include "core/view/scopes/scope_pictures.h"

#include <algorithm>

namespace swaplight {
namespace {

constexpr int kColumns = 512;
constexpr int kSide = 256;
constexpr int kBins = 256;

ScopePicture black(int width, int height) {
  ScopePicture picture{width, height, {}};
  picture.rgba.assign(4 * static_cast<size_t>(width) * static_cast<size_t>(height), 0);
  for (size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  return picture;
}

ScopePicture lit(const ScopeCounts& counts, const Rgb& color, float full) {
  ScopePicture picture = black(counts.width, counts.height);
  addScopeLight(counts, color, full, picture.rgba.data());
  return picture;
}

void copyInto(const ScopePicture& part, int left, ScopePicture& whole) {
  for (int y = 0; y < part.height; ++y)
    std::copy_n(part.rgba.data() + 4 * static_cast<ptrdiff_t>(y) * part.width, 4 * part.width,
                whole.rgba.data() + 4 * (static_cast<ptrdiff_t>(y) * whole.width + left));
}

}  // namespace

ScopePictures scopePictures(const ScopeSample& sample, const glm::mat3& xyzFromRgb,
                            const Rgb& luminanceWeights) {
  ScopePictures pictures;
  const float pixels = static_cast<float>(sample.width()) * static_cast<float>(sample.height());
  // An eighth of a column's pixels on one code is fully bright, and so is one in 500 on a place of a plane.
  const int columns = std::clamp(sample.width(), 1, kColumns);
  const int narrow = std::clamp(sample.width(), 1, kSide);
  const float fullColumn = pixels / static_cast<float>(columns) / 8;
  const float fullPlane = pixels / 500;
  pictures.waveform = lit(waveform(sample, ScopeChannel::Luma, columns), {0.78F, 0.86F, 0.80F}, fullColumn);
  pictures.parade = black(3 * narrow, kSide);
  const std::array<Rgb, 3> inks{{{1, 0.25F, 0.22F}, {0.25F, 0.95F, 0.30F}, {0.30F, 0.45F, 1}}};
  for (size_t c = 0; c < 3; ++c)
    copyInto(lit(waveform(sample, static_cast<ScopeChannel>(c), narrow), inks[c], 2 * fullColumn),
             static_cast<int>(c) * narrow, pictures.parade);
  pictures.vectorscope = lit(vectorscope(sample, kSide), {0.80F, 0.88F, 0.82F}, fullPlane);
  pictures.chromaticity = lit(chromaticityScope(sample, xyzFromRgb, kSide), {0.80F, 0.88F, 0.82F}, fullPlane);
  pictures.codes = codeHistogram(sample);
  pictures.stops =
      stopsHistogram(sample, luminanceWeights, kHistogramLowestStops, kHistogramHighestStops, kBins);
  pictures.linear = linearHistogram(sample, luminanceWeights, kHistogramHighestLinear, kBins);
  return pictures;
}

}  // namespace swaplight
