#include "app/verbs/look_frame.h"

#include <algorithm>
#include <vector>

#include "core/color/srgb.h"
#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"
#include "core/ocio/icc_profile.h"

namespace swaplight {

namespace fs = std::filesystem;

FilteredImage readFrame(const fs::path& file, bool alpha) {
  ImageFile read = readImage(file);
  const FilterSpace space =
      read.info.isFloat || read.info.format == "raw" ? FilterSpace::SceneLinear : FilterSpace::Display;
  const int plane = alpha ? read.image.channelIndex("A") : -1;
  std::vector<float> matte;
  if (plane >= 0) matte.assign(read.image.plane(plane), read.image.plane(plane) + read.image.pixelCount());
  Image rgb = rgbImage(std::move(read.image), file);
  if (!alpha) return {std::move(rgb), space};
  ImageSpec spec = rgb.spec();
  spec.channels.emplace_back("A");
  Image all(spec, 1);
  for (int c = 0; c < 3; ++c) std::copy_n(rgb.plane(c), rgb.pixelCount(), all.plane(c));
  if (!matte.empty()) std::copy(matte.begin(), matte.end(), all.plane(3));
  return {std::move(all), space};
}

void writeFiltered(const ColorConfig& config, FilteredImage frame, const fs::path& file,
                   const LookArguments& arguments) {
  FrameOptions options = arguments.frame;
  if (frame.space == FilterSpace::Display) {
    const DisplayChoice choice =
        options.display.empty() ? DisplayChoice{} : namedDisplay(config, options.display);
    options.linear = true;  // as they are
    options.display = {};
    if (isSceneLinear(file)) {
      for (int c = 0; c < 3; ++c)
        std::transform(frame.image.plane(c), frame.image.plane(c) + frame.image.pixelCount(),
                       frame.image.plane(c), [](float code) { return linearFromSrgb(code); });
      frame.image.setColorSpace("lin_rec709");
    } else {
      options.write.iccProfile =
          choice.empty() ? iccProfileOf("sRGB", "") : iccProfileOf(choice.display, choice.view);
      frame.image.setColorSpace("srgb");
    }
  }
  writeFrame(config, std::move(frame.image), file, options);
}

PipelineOptions pipelineOptionsFor(const ColorConfig& config, const FilteredImage& frame,
                                   const LookArguments& arguments) {
  PipelineOptions options;
  options.time = arguments.time;
  options.tileSide = arguments.tileSide;
  options.mostSecondsPerTile = arguments.mostSeconds;
  options.displayFromScene = [&config, space = frame.image.spec().colorSpace,
                              display = arguments.frame.display](ImageSpan image) {
    if (display.empty())
      config.convert(image, space, "srgb");
    else
      config.applyView(image, space, namedDisplay(config, display));
  };
  return options;
}

}  // namespace swaplight
