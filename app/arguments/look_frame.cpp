#include "app/arguments/look_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"

namespace swaplight {

namespace fs = std::filesystem;

namespace {

bool hasAlphaIn(const ImageFileInfo& info) {
  return info.format == "openexr" ||
         (info.format == "tiff" && !info.numbers.contains("oiio:UnassociatedAlpha"));
}

/// Light that covers nothing: a glow, a flame.
bool hasLightWithoutAlpha(const Image& image) {
  for (size_t p = 0; p < image.pixelCount(); ++p)
    if (image.plane(3)[p] == 0 && std::max({image.plane(0)[p], image.plane(1)[p], image.plane(2)[p]}) > 0)
      return true;
  return false;
}

/// What nothing of is covered stays as it is.
void divideAlphaOut(Image& image) {
  for (int c = 0; c < 3; ++c)
    std::transform(image.plane(c), image.plane(c) + image.pixelCount(), image.plane(3), image.plane(c),
                   [](float value, float alpha) { return alpha > 0 ? value / alpha : value; });
}

}  // namespace

ReadFrame readFrame(const fs::path& file, bool alpha) {
  ImageFile read = readImage(file);
  const FilterSpace space =
      read.info.isFloat || read.info.format == "raw" ? FilterSpace::SceneLinear : FilterSpace::Display;
  const int plane = alpha ? read.image.channelIndex("A") : -1;
  const PixelRect whole{0, 0, read.image.width(), read.image.height()};
  const auto [r, g, b] = rgbChannels(read.image, file);
  auto carried = carriedData(read.image, read.info, std::array<int, 4>{r, g, b, plane});
  std::vector<float> matte;
  if (plane >= 0) matte.assign(read.image.plane(plane), read.image.plane(plane) + read.image.pixelCount());
  Image rgb = rgbImage(std::move(read.image), file);
  std::vector<std::string> warnings;
  if (read.info.dataWindow && enclosing(*read.info.dataWindow, whole) != whole)
    warnings.push_back(fmt::format(
        "{}: holds pixels outside of its display window (overscan): they are left out", file.string()));
  if (!alpha) return {{std::move(rgb), space}, std::move(carried), std::move(warnings)};
  ImageSpec spec = rgb.spec();
  spec.channels.emplace_back("A");
  Image all(spec, 1);
  for (int c = 0; c < 3; ++c) std::copy_n(rgb.plane(c), rgb.pixelCount(), all.plane(c));
  if (!matte.empty()) std::copy(matte.begin(), matte.end(), all.plane(3));
  if (!matte.empty() && hasAlphaIn(read.info)) {
    if (hasLightWithoutAlpha(all))
      warnings.push_back(fmt::format(
          "{}: has light where its alpha is 0 (glows, flames): an EXR of it is black there; without --alpha, "
          "light and alpha go along as they are",
          file.string()));
    divideAlphaOut(all);
  }
  return {{std::move(all), space}, std::move(carried), std::move(warnings)};
}

std::unique_ptr<const ImagesInFiles> largeImagesBeside(const std::filesystem::path& output, int partSide) {
  const auto side = static_cast<size_t>(partSide);
  return std::make_unique<const ImagesInFiles>(output.parent_path(),
                                               ImageMemory{.largest = 3 * sizeof(float) * side * side});
}

}  // namespace swaplight
