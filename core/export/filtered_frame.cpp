#include "core/export/filtered_frame.h"

#include <algorithm>

#include "core/color/srgb.h"

namespace swaplight {
namespace {

DisplayChoice viewOf(const FrameOptions& options) {
  return options.display.empty() ? options.seenThrough : options.display;
}

}  // namespace

std::function<void(ImageSpan)> displayFromScene(const ColorConfig& config, std::string colorSpace,
                                                const FrameOptions& options) {
  return
      [&config, space = std::move(colorSpace), tone = options.tone, view = viewOf(options)](ImageSpan image) {
        if (tone) {
          if (const ColorGrade* grade = view.actingGrade()) config.applyGrade(image, space, *grade);
          config.convert(image, space, "lin_rec709");
          applyStillTone(image, *tone);
          config.convert(image, "lin_rec709", "srgb");
        } else if (view.empty()) {
          config.convert(image, space, "srgb");
        } else {
          config.applyView(image, space, namedDisplay(config, view));
        }
      };
}

FilteredImage gradedLight(const ColorConfig& config, FilteredImage frame, const FrameOptions& options) {
  const ColorGrade* grade = options.seenThrough.actingGrade();
  if (grade && frame.space != FilterSpace::Display && options.display.empty())
    config.applyGrade(frame.image.span(), frame.image.spec().colorSpace, *grade);
  return frame;
}

Image lightOf(FilteredImage frame) {
  if (frame.space != FilterSpace::Display) return std::move(frame.image);
  for (int c = 0; c < 3; ++c)
    std::transform(frame.image.plane(c), frame.image.plane(c) + frame.image.pixelCount(),
                   frame.image.plane(c), [](float code) { return linearFromSrgb(code); });
  frame.image.setColorSpace("lin_rec709");
  return std::move(frame.image);
}

void writeFilteredFrame(const ColorConfig& config, FilteredImage frame, const std::filesystem::path& file,
                        const FrameOptions& options, const Progress& progress) {
  if (frame.space != FilterSpace::Display) {
    writeFrame(config, std::move(frame.image), file, options, progress);
    return;
  }
  if (isSceneLinear(file) || options.linear) {
    FrameOptions light = options;
    light.linear = true;
    light.display = {};
    writeFrame(config, lightOf(std::move(frame)), file, light, progress);
    return;
  }
  const DisplayChoice view = options.tone ? DisplayChoice{} : viewOf(options);
  writeCodes(std::move(frame.image), file, view.empty() ? view : namedDisplay(config, view), options.write,
             progress);
}

}  // namespace swaplight
