#include "core/shadow/result/shadow_file.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/image/io/image_io.h"

namespace swaplight {

void checkShadowFile(const std::filesystem::path& file) {
  if (file.extension() != ".exr")
    throw InputError("{}: shadows are written as OpenEXR. Name it {}.", file.string(),
                     std::filesystem::path(file).replace_extension(".exr").string());
}

void writeShadows(const std::vector<NamedShadows>& lights, const std::filesystem::path& file) {
  checkShadowFile(file);
  const Image& first = lights.front().shadows->visibility;
  ImageSpec spec{first.width(), first.height(), {}, "data"};
  for (const NamedShadows& light : lights)
    for (const char* channel : {"Y", "label"})
      spec.channels.push_back("shadow_" + light.light + "." + channel);
  Image image(spec);
  for (size_t i = 0; i < lights.size(); ++i) {
    const LightShadows& shadows = *lights[i].shadows;
    const auto channel = static_cast<int>(2 * i);
    std::copy_n(shadows.visibility.plane(0), image.pixelCount(), image.plane(channel));
    std::transform(shadows.labels.begin(), shadows.labels.end(), image.plane(channel + 1),
                   [](ShadowLabel label) { return static_cast<float>(label); });
  }
  writeImage(image, file);
}

}  // namespace swaplight
